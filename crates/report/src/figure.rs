//! Drawings inside a page: without headers, with names of their own, as wide as the page.

use serde::Serialize;

/// A drawing of a stage.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct Figure {
    /// The stage that drew it.
    pub stage: String,
    /// Its name, of its own within the stage.
    pub name: String,
    /// What it shows.
    pub caption: String,
    /// The drawing as SVG.
    pub svg: String,
}

impl Figure {
    /// The name of the drawing that stands on the first page where its stage governs, and nowhere else.
    pub const GOVERNING: &str = "governing";

    /// The drawing as it stands in a page: several drawings may use the same names inside, so each gets names of its own.
    pub fn inlined(&self) -> String {
        let body = match self.svg.find("<svg") {
            Some(start) => &self.svg[start..],
            None => return String::new(),
        };
        let own: String = format!("{}-{}", self.stage, self.name)
            .chars()
            .map(|c| if c.is_ascii_alphanumeric() { c } else { '-' })
            .collect();
        let renamed = body
            .replace("id=\"", &format!("id=\"{own}-"))
            .replace("url(#", &format!("url(#{own}-"))
            .replace("href=\"#", &format!("href=\"#{own}-"));
        let label = self.caption.replace('&', "&amp;").replace('"', "&quot;").replace('<', "&lt;");
        let Some(end) = renamed.find('>') else { return String::new() };
        let (open, rest) = renamed.split_at(end);
        let open = without(&without(open, "width"), "height");
        format!("{open} role=\"img\" aria-label=\"{label}\"{rest}")
    }
}

fn without(tag: &str, attribute: &str) -> String {
    let pattern = format!(" {attribute}=\"");
    let Some(start) = tag.find(&pattern) else { return tag.to_owned() };
    let value = start + pattern.len();
    let Some(length) = tag[value..].find('"') else { return tag.to_owned() };
    format!("{}{}", &tag[..start], &tag[value + length + 1..])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_drawing_gets_names_of_its_own_and_no_size() {
        let svg = "<?xml?>\n<svg xmlns=\"x\" width=\"160mm\" height=\"9mm\" viewBox=\"0 0 8 9\"><g id=\"a\" fill=\"url(#a)\"/></svg>";
        let figure = Figure { stage: "s".into(), name: "n 1".into(), caption: "a \"b\"".into(), svg: svg.into() };
        assert_eq!(
            figure.inlined(),
            "<svg xmlns=\"x\" viewBox=\"0 0 8 9\" role=\"img\" aria-label=\"a &quot;b&quot;\"><g id=\"s-n-1-a\" fill=\"url(#s-n-1-a)\"/></svg>"
        );
    }
}
