//! Import circles: files of a crate that use what one another define, however far around. A re-export is no use, and neither are tests.

use proc_macro2::{TokenStream, TokenTree};
use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};
use syn::visit::{self, Visit};
use syn::{Item, UseTree, Visibility};

/// A module's path within its crate.
type Module = Vec<String>;

/// What a file defines, takes in, and names.
#[derive(Default)]
struct Source {
    defines: BTreeSet<String>,
    /// Capitalised words of items that macros make.
    made: BTreeSet<String>,
    /// Of each name that is taken in the path to it, and whether it is given on.
    imports: Vec<(String, Vec<String>, bool)>,
    globs: Vec<Vec<String>>,
    /// Paths in what is not an import.
    names: BTreeSet<Vec<String>>,
}

impl Source {
    fn read(text: &str) -> Source {
        let mut this = Source::default();
        this.items(&syn::parse_file(text).expect("Rust").items);
        this
    }

    fn items(&mut self, items: &[Item]) {
        for item in items.iter().filter(|item| !is_test(item)) {
            if let Item::Use(taken) = item {
                self.take(&taken.tree, Vec::new(), !matches!(taken.vis, Visibility::Inherited));
                continue;
            }
            match item {
                Item::Mod(inner) => {
                    self.items(inner.content.as_ref().map_or(&[][..], |content| &content.1));
                    continue;
                }
                Item::Macro(made) => {
                    self.made.extend(words(made.mac.tokens.clone()).into_iter().filter(|word| capital(word)))
                }
                _ => {}
            }
            self.defines.extend(defined(item));
            self.visit_item(item);
        }
    }

    fn take(&mut self, tree: &UseTree, mut path: Vec<String>, given_on: bool) {
        match tree {
            UseTree::Path(next) => {
                path.push(next.ident.to_string());
                self.take(&next.tree, path, given_on);
            }
            UseTree::Name(name) if name.ident == "self" => {
                let last = path.last().expect("a path before self").clone();
                self.imports.push((last, path, given_on));
            }
            UseTree::Name(name) => {
                path.push(name.ident.to_string());
                self.imports.push((name.ident.to_string(), path, given_on));
            }
            UseTree::Rename(name) => {
                path.push(name.ident.to_string());
                self.imports.push((name.rename.to_string(), path, given_on));
            }
            UseTree::Glob(_) => self.globs.push(path),
            UseTree::Group(group) => group.items.iter().for_each(|tree| self.take(tree, path.clone(), given_on)),
        }
    }
}

impl<'ast> Visit<'ast> for Source {
    fn visit_path(&mut self, path: &'ast syn::Path) {
        self.names.insert(path.segments.iter().map(|segment| segment.ident.to_string()).collect());
        visit::visit_path(self, path);
    }

    fn visit_visibility(&mut self, _: &'ast Visibility) {}

    fn visit_item_use(&mut self, taken: &'ast syn::ItemUse) {
        self.take(&taken.tree, Vec::new(), false);
    }

    fn visit_macro(&mut self, called: &'ast syn::Macro) {
        self.names.extend(paths(called.tokens.clone()));
        visit::visit_macro(self, called);
    }
}

fn capital(word: &str) -> bool {
    word.starts_with(|first: char| first.is_uppercase())
}

/// Whether an item is a test's.
fn is_test(item: &Item) -> bool {
    let attributes = match item {
        Item::Mod(item) => &item.attrs,
        Item::Fn(item) => &item.attrs,
        Item::Use(item) => &item.attrs,
        Item::Impl(item) => &item.attrs,
        Item::Const(item) => &item.attrs,
        Item::Struct(item) => &item.attrs,
        _ => return false,
    };
    attributes.iter().any(|attribute| match &attribute.meta {
        syn::Meta::List(list) => list.path.is_ident("cfg") && list.tokens.to_string() == "test",
        _ => false,
    })
}

fn defined(item: &Item) -> Option<String> {
    let name = match item {
        Item::Const(item) => &item.ident,
        Item::Enum(item) => &item.ident,
        Item::Fn(item) => &item.sig.ident,
        Item::Static(item) => &item.ident,
        Item::Struct(item) => &item.ident,
        Item::Trait(item) => &item.ident,
        Item::Type(item) => &item.ident,
        Item::Union(item) => &item.ident,
        Item::Macro(item) => item.ident.as_ref()?,
        _ => return None,
    };
    Some(name.to_string())
}

/// All words of some tokens.
fn words(tokens: TokenStream) -> Vec<String> {
    paths(tokens).into_iter().flatten().collect()
}

/// Words of some tokens, those joined by `::` together.
fn paths(tokens: TokenStream) -> Vec<Vec<String>> {
    let mut found: Vec<Vec<String>> = Vec::new();
    let (mut colons, mut open) = (0, false);
    for token in tokens {
        match token {
            TokenTree::Ident(word) => {
                match found.last_mut().filter(|_| open && colons == 2) {
                    Some(path) => path.push(word.to_string()),
                    None => found.push(vec![word.to_string()]),
                }
                (colons, open) = (0, true);
            }
            TokenTree::Punct(mark) if mark.as_char() == ':' => colons += 1,
            TokenTree::Group(group) => {
                found.extend(paths(group.stream()));
                (colons, open) = (0, false);
            }
            _ => (colons, open) = (0, false),
        }
    }
    found
}

/// The files of a crate by their modules.
struct Files(BTreeMap<Module, Source>);

/// What a path leads to.
enum Place {
    /// An item that this module defines.
    Item(Module),
    Module(Module),
}

impl Files {
    fn below(folder: &Path) -> Files {
        let mut found = BTreeMap::new();
        let mut open = vec![(folder.to_owned(), Vec::new())];
        while let Some((folder, module)) = open.pop() {
            for entry in fs::read_dir(&folder).expect("a folder of sources").flatten() {
                let path = entry.path();
                let name = path.file_stem().and_then(|name| name.to_str()).unwrap_or_default().to_owned();
                if name == "tests" || name.ends_with("_tests") {
                    continue;
                }
                let mut own: Module = module.clone();
                if path.is_dir() {
                    own.push(name);
                    open.push((path, own));
                } else if path.extension().is_some_and(|ending| ending == "rs") {
                    if !matches!(name.as_str(), "mod" | "lib" | "main") {
                        own.push(name);
                    }
                    found.insert(own, Source::read(&fs::read_to_string(&path).expect("a source")));
                }
            }
        }
        Files(found)
    }

    /// Where a path leads from a module; none out of the crate. `depth` ends imports that name one another.
    fn place(&self, from: &Module, path: &[String], depth: usize) -> Option<Place> {
        let (mut at, mut rest) = (from.clone(), path);
        while let Some(first) = rest.first() {
            match first.as_str() {
                "crate" => at = Vec::new(),
                "self" => {}
                "super" => {
                    at.pop();
                }
                _ => match self.named(&at, first, depth)? {
                    Place::Item(module) => return Some(Place::Item(module)),
                    Place::Module(module) => at = module,
                },
            }
            rest = &rest[1..];
        }
        Some(Place::Module(at))
    }

    fn named(&self, module: &Module, name: &str, depth: usize) -> Option<Place> {
        let source = self.0.get(module)?;
        if depth == 0 {
            return None;
        }
        if source.defines.contains(name) {
            return Some(Place::Item(module.clone()));
        }
        if let Some((_, path, _)) = source.imports.iter().find(|(own, ..)| own == name)
            && let Some(place) = self.place(module, path, depth - 1)
        {
            return Some(place);
        }
        let child: Module = module.iter().cloned().chain([name.to_owned()]).collect();
        if self.0.contains_key(&child) {
            return Some(Place::Module(child));
        }
        let of_glob = source.globs.iter().find_map(|glob| match self.place(module, glob, depth - 1)? {
            Place::Module(other) if other != *module => self.named(&other, name, depth - 1),
            _ => None,
        });
        of_glob.or_else(|| source.made.contains(name).then(|| Place::Item(module.clone())))
    }

    /// The files whose items a file uses.
    fn used(&self, module: &Module) -> BTreeSet<Module> {
        let source = &self.0[module];
        let firsts: BTreeSet<&String> = source.names.iter().filter_map(|path| path.first()).collect();
        let imports = source.imports.iter().filter(|(name, _, given_on)| !given_on || firsts.contains(name));
        let paths = imports.map(|(_, path, _)| path).chain(&source.names);
        let places = paths.filter_map(|path| match self.place(module, path, 12)? {
            Place::Item(other) => Some(other),
            Place::Module(_) => None,
        });
        places.filter(|other| other != module).collect()
    }
}

/// The circles of a crate's files, largest first.
fn circles(folder: &Path) -> Vec<Vec<String>> {
    let files = Files::below(folder);
    let uses: BTreeMap<&Module, BTreeSet<Module>> = files.0.keys().map(|module| (module, files.used(module))).collect();
    let reached = |from: &Module| {
        let (mut seen, mut open) = (BTreeSet::new(), vec![from.clone()]);
        while let Some(module) = open.pop() {
            open.extend(uses[&module].iter().filter(|next| seen.insert((*next).clone())).cloned());
        }
        seen
    };
    let all: BTreeMap<&Module, BTreeSet<Module>> = files.0.keys().map(|module| (module, reached(module))).collect();
    let mut found: BTreeSet<Vec<String>> = BTreeSet::new();
    for (module, reach) in all.iter().filter(|(module, reach)| reach.contains(**module)) {
        let around = reach.iter().filter(|other| all[other].contains(*module));
        found.insert(around.map(|module| module.join("::")).collect());
    }
    let mut found: Vec<Vec<String>> = found.into_iter().collect();
    found.sort_by_key(|circle| std::cmp::Reverse(circle.len()));
    found
}

/// Files in one circle have to be read together: so many are.
const MOST: usize = 6;

#[test]
#[expect(clippy::print_stdout, reason = "how large the circles of every crate are")]
fn no_crate_has_a_large_import_circle() {
    let crates = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    let mut folders: Vec<PathBuf> =
        fs::read_dir(&crates).expect("crates").flatten().map(|one| one.path().join("src")).collect();
    folders.retain(|folder| folder.is_dir());
    folders.sort();
    assert!(folders.len() > 15, "{folders:?}");
    let mut all = 0;
    for folder in folders {
        let found = circles(&folder);
        let name = folder.parent().and_then(Path::file_name).expect("a crate").to_string_lossy().into_owned();
        println!("{name:14} {:?}", found.iter().map(Vec::len).collect::<Vec<_>>());
        all += found.len();
        if let Some(large) = found.first().filter(|circle| circle.len() > MOST) {
            panic!("{name}: {} files use one another: {}", large.len(), large.join(", "));
        }
    }
    // Small ones there are: files of one method that call back and forth.
    assert!(all > 20, "{all}");
}

/// Round by an import, by a path, by what a macro is given, through a re-export and a glob; not by a re-export alone, and not by tests.
#[test]
fn a_circle_is_found_however_files_name_one_another() {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("circles");
    fs::create_dir_all(&folder).expect("the folder of build results can be written");
    let write = |name: &str, text: &str| fs::write(folder.join(name), text).expect("a file");
    write("lib.rs", "mod a;\nmod b;\nmod c;\nmod d;\npub use a::A;\nuse b::*;\nfn go() -> B { todo!() }\n");
    write("a.rs", "use crate::b::B;\npub struct A(B);\n");
    write("b.rs", "pub struct B;\nimpl B { fn f() -> u8 { super::c::C } }\n");
    write("c.rs", "pub const C: u8 = 1;\nfn f() { println!(\"{:?}\", crate::A(todo!())); }\n");
    write("d.rs", "pub struct D;\n#[cfg(test)]\nmod tests { use crate::go; }\nuse crate::c::C;\n");
    assert_eq!(circles(&folder), [["a", "b", "c"]]);
}
