//! Disks that are full, and folders that cannot be written.

#![cfg(unix)]

use crate::stage::{Ending, PROGRAM, Stage};
use crate::tally::{End, Tally};
use crate::works::{WORKS, Whole, Work, asked_for, is_sealed, left_over, prepared};
use std::fs;
use std::process::{Command, Stdio};

/// Largest files that are allowed [KiB].
const SIZES: [u32; 6] = [0, 1, 4, 16, 64, 256];

/// Runs a work where no file may be larger than so many KiB: writing fails as on a full disk.
fn limited(stage: &Stage, work: &Work, out: &str, size: u32) -> Ending {
    let script = format!("trap '' XFSZ; ulimit -f {size}; exec \"$@\"");
    let words = work.line(out, false);
    let mut command = Command::new("bash");
    // What is printed goes through pipes, which have no such limit.
    command.args(["-c", &script, "bash", PROGRAM]).args(words).current_dir(&stage.folder).stdin(Stdio::null());
    command.output().expect("bash is there").into()
}

fn full(stage: &Stage, work: &Work, sizes: &[u32], tally: &mut Tally) {
    let whole = Whole::of(stage, work);
    let folder = stage.folder.join("full");
    let _ = fs::remove_dir_all(&folder);
    for size in sizes {
        let ending = limited(stage, work, "full", *size);
        judge(&whole, &ending, &folder, work, &format!("full disk, {size} KiB"), tally);
        // With room again, the same command does its work.
        let again: Ending = stage.run(&work.line("full", true));
        match whole.differs(&again, &folder) {
            Some(what) => tally.fault("with room again", work.name, End::Lost, format!("{what} (after {size} KiB)")),
            None => tally.count("with room again", work.name, End::Answered),
        }
        let _ = fs::remove_dir_all(&folder);
    }
}

/// A run on a full disk ends as the whole one did, or says that it could not write; it leaves no half of a result.
fn judge(whole: &Whole, ending: &Ending, folder: &std::path::Path, work: &Work, what: &str, tally: &mut Tally) {
    let left = left_over(folder);
    let said = ["F102", "F109"].iter().any(|code| ending.stderr.contains(code) || ending.stdout.contains(code));
    let kind = "full disk";
    match (ending.code, is_sealed(folder)) {
        (None | Some(101), _) => tally.fault(kind, work.name, End::Broken, format!("{what}: {}", ending.stderr)),
        (_, Err(torn)) => tally.fault(kind, work.name, End::Lost, format!("{what}: {torn}")),
        _ if !left.is_empty() => tally.fault(kind, work.name, End::Lost, format!("{what}: {left:?} stay")),
        (code, _) if code == whole.code => tally.count(kind, work.name, End::Answered),
        (Some(2), Ok(false)) if said => tally.count(kind, work.name, End::Refused),
        (Some(3), Ok(false)) if said => tally.count(kind, work.name, End::Unfinished),
        // A fleet goes on where one bridge could not be written, and tells which.
        (Some(3), Ok(true)) if said && work.name == "assess of a folder" => {
            tally.count(kind, work.name, End::Unfinished);
        }
        (code, sealed) => {
            let told = format!("{what}: exit code {code:?}, sealed {sealed:?}: {}", ending.stderr);
            tally.fault(kind, work.name, End::Lost, told);
        }
    }
}

/// A small file system that is really full; none where this user may not mount one.
struct Mounted(std::path::PathBuf);

impl Mounted {
    fn of(stage: &Stage, kib: u32) -> Option<Mounted> {
        let place = stage.folder.join("small");
        fs::create_dir_all(&place).ok()?;
        let size = format!("size={kib}k");
        let done = Command::new("mount").args(["-t", "tmpfs", "-o", &size, "tmpfs"]).arg(&place).output().ok()?;
        done.status.success().then_some(Mounted(place))
    }
}

impl Drop for Mounted {
    fn drop(&mut self) {
        let _ = Command::new("umount").arg(&self.0).status();
    }
}

fn mounted(stage: &Stage, work: &Work, tally: &mut Tally) {
    let whole = Whole::of(stage, work);
    for kib in [8, 64, 512] {
        let Some(small) = Mounted::of(stage, kib) else {
            println!("no small file system can be mounted here: full disks are limits on the size of files alone");
            return;
        };
        let ending: Ending = stage.run(&work.line("small/o", false));
        judge(&whole, &ending, &small.0.join("o"), work, &format!("a disk of {kib} KiB"), tally);
    }
}

/// A folder that this user cannot write: of the kernel for who may write everywhere else.
fn read_only(stage: &Stage, work: &Work, tally: &mut Tally) {
    use std::os::unix::fs::PermissionsExt;
    let closed = stage.folder.join("closed");
    fs::create_dir_all(&closed).expect("a folder");
    fs::set_permissions(&closed, fs::Permissions::from_mode(0o555)).expect("closed");
    let everywhere = fs::write(closed.join("probe"), b"").is_ok();
    let out = if everywhere { "/proc/extrados-out" } else { "closed/out" };
    let ending = stage.run(&work.line(out, false));
    fs::set_permissions(&closed, fs::Permissions::from_mode(0o755)).expect("open");
    match ending.code {
        Some(2) if ending.stdout.contains("F102") => tally.count("read-only folder", work.name, End::Refused),
        code => tally.fault("read-only folder", work.name, End::Broken, format!("{code:?}: {}", ending.stderr)),
    }
}

fn run(name: &str, works: &[Work], sizes: &[u32]) -> Tally {
    let (stage, mut tally) = (prepared(name), Tally::default());
    for work in works {
        full(&stage, work, sizes, &mut tally);
        mounted(&stage, work, &mut tally);
        read_only(&stage, work, &mut tally);
    }
    tally
}

#[test]
fn robustness_a_full_disk_is_told_and_leaves_no_half() {
    run("robustness-few-disks", &[WORKS[1], WORKS[3]], &[0, 16]).settle("Full disks and read-only folders");
}

#[test]
#[ignore = "minutes"]
fn robustness_full_disks_under_every_command() {
    run("robustness-disks", &asked_for(WORKS.into_iter()), &SIZES).settle("Full disks and read-only folders");
}
