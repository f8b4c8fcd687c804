//! Interactive load placement: the same numbers as analyses that begin anew.

use extrados::results::collapse::Status;
use extrados::{
    Choice, CollapseOptions, Memory, Placing, Project, SweepOptions, Swept, Unwatched, VehicleChoice, collapse, sweep,
};

fn project(text: &str) -> Project {
    let project = Project::read("bridge.toml", &Memory::default().with("bridge.toml", text)).expect("a file");
    project.bridge().expect("a bridge");
    project
}

const TINY: &str = include_str!("../../../../examples/tiny/bridge.toml");
const VIADUCT: &str = include_str!("../../../../examples/viaduct/bridge.toml");

fn close(a: Option<f64>, b: Option<f64>, within: f64) -> bool {
    match (a, b) {
        (Some(a), Some(b)) => (a - b).abs() <= within * a.abs().max(b.abs()),
        (a, b) => a == b,
    }
}

/// At the place of the file a load carries what the analysis of the file finds, and with it the mechanism.
#[test]
fn the_place_of_the_file_gives_the_collapse_of_the_file() {
    let project = project(TINY);
    let alone = collapse(&project, &CollapseOptions::default(), &mut Unwatched).expect("a collapse");
    let mut placing = Placing::loads(&project, &Choice::default()).expect("a bridge that waits");
    // Elsewhere before, so that what was learnt there is a start here.
    for place in [0.4, 3.1, 2.0] {
        placing.put(place);
    }
    let placed = placing.put(1.0);
    assert_eq!(placed.status, Status::Collapsed);
    let load = placed.factor.map(|factor| factor * placed.reference);
    assert!(close(load, alone.collapse_load, 1e-6), "{load:?} {:?}", alone.collapse_load);
    assert!(close(placing.carried(1.0).factor, placed.factor, 1e-9));
    let ends =
        |hinges: &[extrados::results::picture::Hinge]| hinges.iter().map(|hinge| hinge.between).collect::<Vec<_>>();
    assert_eq!(ends(&placed.picture.hinges), ends(&alone.picture.hinges));
    assert_eq!(placed.picture.thrust_lines.len(), alone.picture.thrust_lines.len());
    let (mine, theirs) = (&placed.picture.thrust_lines[0], &alone.picture.thrust_lines[0]);
    assert_eq!(mine.len(), theirs.len());
    assert_eq!(placed.strips.len(), 1);
    assert!((placed.strips[0].0[0] - 1.0).abs() < 1e-12);
}

/// Where a load comes from does not matter, and every place of a sweep is answered as the sweep answers it.
#[test]
fn places_are_those_of_a_sweep_whatever_came_before() {
    let project = project(TINY);
    // A slip in the unit is refused, and not swept for days.
    let slipped = SweepOptions { step: Some(1e-9), ..SweepOptions::default() };
    assert_eq!(sweep(&project, &slipped, &mut Unwatched).expect_err("too close").code, "F107");
    let options = SweepOptions { step: Some(0.25), ..SweepOptions::default() };
    let Swept::Loads(swept) = sweep(&project, &options, &mut Unwatched).expect("a sweep") else { panic!("loads") };
    let mut onward = Placing::loads(&project, &Choice::default()).expect("a bridge that waits");
    let mut back = Placing::loads(&project, &Choice::default()).expect("a bridge that waits");
    let forth: Vec<_> = swept.points.iter().map(|point| onward.carried(point.position)).collect();
    let mut answered = 0;
    for (point, one) in swept.points.iter().zip(&forth).rev() {
        let other = back.carried(point.position);
        assert!(close(one.factor, other.factor, 1e-6), "{}: {one:?} {other:?}", point.position);
        // Where blocks lock with dilation a sweep has a number as well, however large.
        if let Some(factor) = point.load_factor.filter(|_| one.dilatant.is_some()) {
            assert!(close(one.factor, Some(factor), 1e-6), "{}: {one:?} {factor}", point.position);
            answered += 1;
        }
    }
    assert!(answered > 10, "{answered}");
    let [from, to] = onward.range();
    assert!(from <= 0.0 && to >= 4.0);
    assert!(onward.stands() && onward.is_quick() && !onward.assumptions().is_empty());
}

/// A whole vehicle carries at least what its worst run of axles does, and mirrored on a symmetric bridge it carries the same.
#[test]
fn a_vehicle_is_the_same_from_both_sides_and_never_below_its_sweep() {
    let project = project(TINY);
    let asked = |leftward| VehicleChoice { vehicle: "hl-93-truck".to_owned(), rule: String::new(), leftward };
    let mut right = Placing::vehicle(&project, &Choice::default(), &asked(false)).expect("a vehicle");
    let mut left = Placing::vehicle(&project, &Choice::default(), &asked(true)).expect("a vehicle");
    assert_eq!(right.driven().expect("a vehicle").axles().len(), 3);
    let mut least = f64::INFINITY;
    for step in 0..40 {
        let place = 0.1 + 0.2 * f64::from(step);
        let (one, other) = (right.carried(place), left.carried(4.0 - place));
        assert!(close(one.factor, other.factor, 1e-6), "{place}: {one:?} {other:?}");
        least = least.min(one.factor.unwrap_or(f64::INFINITY));
    }
    let text = format!("{TINY}sweep = {{ rule = \"characteristic\", vehicles = [\"hl-93-truck\"] }}\n");
    let swept = sweep(&self::project(&text), &SweepOptions::default(), &mut Unwatched).expect("a sweep");
    let Swept::Vehicles(swept) = swept else { panic!("vehicles") };
    let worst = swept.vehicles[0].factor().expect("a factor");
    assert!(least >= worst * (1.0 - 1e-6) && least < 3.0 * worst, "{least} {worst}");
    let unknown = VehicleChoice { vehicle: "ox-cart".to_owned(), ..VehicleChoice::default() };
    let refused = Placing::vehicle(&project, &Choice::default(), &unknown).err().expect("no such vehicle");
    assert!(refused.message.contains("ox-cart"), "{refused}");
}

/// Under a pointer that moves the answer with dilation comes first: never less than the careful one, and open where they differ.
#[test]
fn a_quick_answer_says_where_it_is_open() {
    let (mut open, mut closed, mut lower) = (0, 0, 0);
    let two_rings = include_str!("../../../../examples/two-ring/bridge.toml");
    for text in [TINY.to_owned(), TINY.replace("35 deg", "20 deg"), two_rings.to_owned()] {
        let project = project(&text);
        let mut placing = Placing::loads(&project, &Choice::default()).expect("a bridge that waits");
        for step in 1..20 {
            let place = 0.2 * f64::from(step);
            let (quick, careful) = (placing.put_quickly(place), placing.put(place));
            if !quick.is_open {
                closed += 1;
                assert!(close(quick.factor, careful.factor, 1e-6), "{place}: {:?} {:?}", quick.factor, careful.factor);
                continue;
            }
            open += 1;
            let [quick, careful] = [quick, careful].map(|one| one.factor.unwrap_or(f64::INFINITY));
            assert!(careful <= quick * (1.0 + 1e-6), "{place}: {quick} {careful}");
            lower += usize::from(careful < 0.999 * quick);
        }
    }
    assert!(open > 0 && closed > 0 && lower > 0, "{open} {closed} {lower}");
}

/// The zone holds the line of thrust of the load that is carried, and closes on it at collapse.
#[test]
fn the_zone_of_thrust_closes_at_collapse() {
    let project = project(TINY);
    let mut placing = Placing::loads(&project, &Choice::default()).expect("a bridge that waits");
    let placed = placing.put(1.0);
    let factor = placed.factor.expect("a factor");
    let mut width = |share: f64| {
        let rings = placing.zone(1.0, share * factor).expect("a zone");
        let each = rings.iter().flatten().map(|[low, high]| (low[0] - high[0]).hypot(low[1] - high[1]));
        each.fold(0.0, f64::max)
    };
    let (half, nearly) = (width(0.5), width(0.999));
    assert!(half > 0.02 && nearly < 0.2 * half, "{half} {nearly}");
    assert!(placing.zone(1.0, 1.1 * factor).expect("a zone").iter().all(Vec::is_empty));
}

/// Three spans with slender piers: each place is answered, and spans between which the load passes are told apart.
#[test]
fn a_viaduct_is_answered_all_along() {
    let project = project(VIADUCT);
    let mut placing = Placing::vehicle(&project, &Choice::default(), &VehicleChoice::default()).expect("a vehicle");
    let [from, to] = placing.range();
    let mut answered = 0;
    for step in 0..=30 {
        let placed = placing.put(from + (to - from) * f64::from(step) / 30.0);
        answered += usize::from(placed.factor.is_some());
        if let Some(factor) = placed.factor {
            assert!(factor > 0.0 && placed.bounds[1].is_none_or(|upper| factor <= upper * (1.0 + 1e-6)));
            assert!(placed.picture.mechanism.is_some());
        }
    }
    assert!(answered > 20, "{answered}");
}
