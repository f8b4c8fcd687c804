//! What drawings contain, judged from the SVG and from what the renderer makes of it.

mod sample;

use outcome::picture::{Hinge, HingeAt, Partner, Picture};
use resvg::usvg;
use roxmltree::{Document, Node};
use std::sync::Arc;

/// Nodes of a tag that carry a class.
fn classed<'a>(document: &'a Document, tag: &str, class: &str) -> Vec<Node<'a, 'a>> {
    let has = |n: &Node| n.attribute("class").is_some_and(|c| c.split(' ').any(|c| c == class));
    document.descendants().filter(|n| n.has_tag_name(tag) && has(n)).collect()
}

fn points(node: &Node) -> Vec<[f64; 2]> {
    let number = |t: &str| t.parse::<f64>().unwrap();
    let point = |p: &str| p.split_once(',').map(|(x, y)| [number(x), number(y)]).unwrap();
    node.attribute("points").unwrap().split(' ').map(point).collect()
}

fn texts(document: &Document) -> Vec<String> {
    document.descendants().filter(|n| n.has_tag_name("text")).map(|n| n.text().unwrap().to_string()).collect()
}

fn number(node: &Node, name: &str) -> f64 {
    node.attribute(name).unwrap().parse().unwrap()
}

/// Every drawing of every sample.
fn every_drawing() -> Vec<(String, String)> {
    let mut all = Vec::new();
    for (name, picture) in sample::every() {
        all.extend(figures::drawings(&picture).into_iter().map(|(kind, svg)| (format!("{name}/{kind}"), svg)));
    }
    let sweep = figures::envelope("Sweep", figures::Ordinate::Factor, &sample::sweeps(), None).unwrap();
    all.push(("envelope".into(), sweep));
    for (name, study) in sample::studies::every() {
        all.extend(figures::study_drawings(&study).into_iter().map(|(kind, svg)| (format!("{name}/{kind}"), svg)));
    }
    for (name, update) in [("twin", sample::updates::twin()), ("hard", sample::updates::hard())] {
        all.extend(figures::update_drawings(&update).into_iter().map(|(kind, svg)| (format!("{name}/{kind}"), svg)));
    }
    all
}

fn rendered(svg: &str) -> usvg::Tree {
    let mut fonts = usvg::fontdb::Database::new();
    fonts.load_font_data(dejavu::sans::regular().to_vec());
    fonts.load_font_data(dejavu::sans::bold().to_vec());
    usvg::Tree::from_str(svg, &usvg::Options { fontdb: Arc::new(fonts), ..Default::default() }).unwrap()
}

fn text_boxes(group: &usvg::Group, out: &mut Vec<(String, usvg::Rect)>) {
    for node in group.children() {
        match node {
            usvg::Node::Text(text) => {
                let words = text.chunks().iter().map(|c| c.text()).collect();
                out.push((words, text.abs_bounding_box()));
            }
            usvg::Node::Group(inner) => text_boxes(inner, out),
            _ => {}
        }
    }
}

#[test]
fn all_drawings_are_well_formed_and_free_of_impossible_numbers() {
    let all = every_drawing();
    assert!(all.len() > 20, "{} drawings", all.len());
    for (name, svg) in all {
        let document = Document::parse(&svg).unwrap_or_else(|e| panic!("{name}: {e}"));
        assert!(document.root_element().has_tag_name("svg"), "{name}");
        for node in document.descendants() {
            for a in node.attributes() {
                assert!(!a.value().contains("NaN") && !a.value().contains("inf"), "{name}: {}", a.value());
            }
        }
        for id in document.descendants().filter_map(|n| n.attribute("id")) {
            assert_eq!(svg.matches(&format!("id=\"{id}\"")).count(), 1, "{name}: {id} twice");
        }
    }
}

#[test]
fn no_text_covers_another_or_leaves_the_sheet() {
    for (name, svg) in every_drawing() {
        let tree = rendered(&svg);
        let mut boxes = Vec::new();
        text_boxes(tree.root(), &mut boxes);
        assert!(!boxes.is_empty(), "{name} has no text");
        for (k, (text, a)) in boxes.iter().enumerate() {
            let (w, h) = (tree.size().width(), tree.size().height());
            let inside = a.left() >= 0.0 && a.top() >= 0.0 && a.right() <= w && a.bottom() <= h;
            assert!(inside, "{name}: '{text}' leaves the sheet: {a:?}");
            for (other, b) in &boxes[k + 1..] {
                let apart =
                    a.right() <= b.left() || b.right() <= a.left() || a.bottom() <= b.top() || b.bottom() <= a.top();
                // The renderer's boxes span the whole line height, so that stacked lines of one paragraph overlap by
                // their empty margins; letters themselves begin a fifth of the line height inside.
                let (dy, line) = ((a.bottom().min(b.bottom()) - a.top().max(b.top())), a.height().min(b.height()));
                assert!(apart || dy < 0.2 * line, "{name}: '{text}' covers '{other}'");
            }
        }
    }
}

#[test]
fn every_block_is_drawn_once_and_supports_are_told_apart() {
    for (name, picture) in sample::every() {
        let svg = figures::bridge_as_drawn(&picture);
        let document = Document::parse(&svg).unwrap();
        let held = picture.shapes.iter().filter(|s| s.held).count();
        assert_eq!(classed(&document, "polygon", "support").len(), held, "{name}");
        assert_eq!(classed(&document, "polygon", "block").len(), picture.shapes.len() - held, "{name}");
    }
}

#[test]
fn dimensions_are_those_of_the_bridge() {
    let svg = figures::bridge_as_drawn(&sample::arch());
    let words = texts(&Document::parse(&svg).unwrap());
    for size in ["18.3 m", "2.85 m", "0.711 m"] {
        assert_eq!(words.iter().filter(|t| *t == size).count(), 1, "{size} in {words:?}");
    }
}

#[test]
fn dimension_lines_are_as_long_as_they_say() {
    let picture = sample::arch();
    let svg = figures::bridge_as_drawn(&picture);
    let document = Document::parse(&svg).unwrap();
    let supports: Vec<_> = classed(&document, "polygon", "support").iter().map(points).collect();
    // Units per metre, from the distance between the outer edges of the supports.
    let outer = |p: &[outcome::picture::Shape]| {
        let x = p.iter().filter(|s| s.held).flat_map(|s| &s.outline).map(|p| p[0]);
        x.clone().fold(f64::MIN, f64::max) - x.fold(f64::MAX, f64::min)
    };
    let x = supports.iter().flatten().map(|p| p[0]);
    let scale = (x.clone().fold(f64::MIN, f64::max) - x.fold(f64::MAX, f64::min)) / outer(&picture.shapes);
    let lines = classed(&document, "polyline", "dimension");
    let length = |n: &Node| {
        let p = points(n);
        (p[1][0] - p[0][0]).hypot(p[1][1] - p[0][1])
    };
    // The span's line runs 5 units past both of its ends.
    let (span, rise) = ((length(&lines[0]) - 10.0) / scale, length(&lines[1]) / scale);
    // Coordinates are rounded to 0.005 units, a sixth of a millimetre at this scale.
    assert!((span - 18.3).abs() < 1e-3 && (rise - 2.85).abs() < 1e-3, "{span} {rise}");
}

#[test]
fn the_scale_bar_is_as_long_as_it_says() {
    let picture = sample::arch();
    let svg = figures::bridge_as_drawn(&picture);
    let document = Document::parse(&svg).unwrap();
    let bar = document.descendants().find(|n| n.attribute("class") == Some("scale-bar")).unwrap();
    let ends: Vec<f64> =
        bar.children().filter(|n| n.has_tag_name("polygon")).flat_map(|n| points(&n)).map(|p| p[0]).collect();
    let length = ends.iter().copied().fold(f64::MIN, f64::max) - ends.iter().copied().fold(f64::MAX, f64::min);
    let words = bar.descendants().find(|n| n.has_tag_name("text")).and_then(|n| n.text()).unwrap();
    let metres: f64 = words.strip_suffix(" m").unwrap().parse().unwrap();
    // The first voussoir's intrados edge is drawn to the same scale.
    let first = points(&classed(&document, "polygon", "block")[0]);
    let drawn = (first[1][0] - first[0][0]).hypot(first[1][1] - first[0][1]);
    let o = &picture.shapes[0].outline;
    let true_length = (o[1][0] - o[0][0]).hypot(o[1][1] - o[0][1]);
    // Coordinates are rounded to 0.005 at both ends of a line about ten units long.
    assert!((drawn / true_length / (length / metres) - 1.0).abs() < 2e-3);
}

#[test]
fn hinges_of_the_mechanism_lie_where_blocks_turn() {
    let picture = sample::arch();
    let svg = figures::mechanism(&picture).unwrap();
    let document = Document::parse(&svg).unwrap();
    let hinges = classed(&document, "circle", "hinge");
    assert_eq!(hinges.len(), picture.hinges.len());
    let corners: Vec<[f64; 2]> = classed(&document, "polygon", "block").iter().flat_map(points).collect();
    for h in &hinges {
        let at = [number(h, "cx"), number(h, "cy")];
        let near = corners.iter().map(|c| (c[0] - at[0]).hypot(c[1] - at[1])).fold(f64::MAX, f64::min);
        // Both are rounded to a hundredth of a unit.
        assert!(near < 0.03, "hinge {near} from the nearest corner");
    }
    let words = texts(&document);
    let named = |w: &str| words.iter().filter(|t| t.len() < 14 && t.ends_with(w)).count();
    assert_eq!((named(" intrados"), named(" extrados")), (2, 2));
    assert!(words.iter().any(|t| t.contains("exaggerated")));
}

#[test]
fn the_mechanism_is_exaggerated_but_not_torn() {
    let picture = sample::arch();
    let svg = figures::mechanism(&picture).unwrap();
    let document = Document::parse(&svg).unwrap();
    let built = classed(&document, "polygon", "ghost");
    let moved = classed(&document, "polygon", "block");
    assert_eq!(built.len(), moved.len());
    let shift = |k: usize| {
        let (a, b) = (points(&built[k]), points(&moved[k]));
        a.iter().zip(&b).map(|(p, q)| (q[0] - p[0]).hypot(q[1] - p[1])).fold(0.0, f64::max)
    };
    let largest = (0..built.len()).map(shift).fold(0.0, f64::max);
    // A twentieth of the larger dimension of the bridge, which fills nearly the whole sheet of 800 units.
    assert!(largest > 30.0 && largest < 42.0, "{largest}");
    // Neighbours of one rigid part keep their common joint.
    for k in [3, 10, 30, 50] {
        let (a, b) = (points(&moved[k]), points(&moved[k + 1]));
        assert!((a[1][0] - b[0][0]).hypot(a[1][1] - b[0][1]) < 0.03, "joint {k}");
    }
}

#[test]
fn sliding_joints_get_a_pair_of_arrows() {
    for picture in [sample::two_rings(), sample::single_block()] {
        let svg = figures::mechanism(&picture).unwrap();
        let document = Document::parse(&svg).unwrap();
        let shafts = classed(&document, "polyline", "sliding");
        assert_eq!(shafts.len(), 2 * picture.sliding.len(), "{}", picture.title);
    }
    // The single block slides to the right on its support: the upper arrow points right, the lower one left.
    let svg = figures::mechanism(&sample::single_block()).unwrap();
    let document = Document::parse(&svg).unwrap();
    let arrows: Vec<_> = classed(&document, "polyline", "sliding").iter().map(points).collect();
    for arrow in &arrows {
        let upper = arrow[0][1] <= arrows.iter().map(|a| a[0][1]).fold(f64::MAX, f64::min);
        assert_eq!(arrow[1][0] > arrow[0][0], upper);
    }
}

#[test]
fn the_line_of_thrust_is_drawn_as_given() {
    let picture = sample::multi_span();
    let svg = figures::thrust_line(&picture).unwrap();
    let document = Document::parse(&svg).unwrap();
    let lines = classed(&document, "polyline", "thrust");
    assert_eq!(lines.len(), 3);
    assert_eq!(points(&lines[0]).len(), picture.thrust_lines[0].len());
    let words = texts(&document);
    // Springings and crown of each span.
    assert_eq!(words.iter().filter(|t| t.ends_with(" kN/m") && t.len() < 12).count(), 9);
}

#[test]
fn stress_colours_every_free_block_and_marks_every_contact_under_stress() {
    let picture = sample::arch();
    let svg = figures::stress(&picture, 3).unwrap();
    let document = Document::parse(&svg).unwrap();
    assert_eq!(classed(&document, "polygon", "block").len(), 62);
    assert_eq!(classed(&document, "polyline", "contact").len(), picture.snapshots[3].contacts.len());
    let fills: std::collections::BTreeSet<_> =
        classed(&document, "polygon", "block").iter().map(|n| n.attribute("fill").unwrap().to_string()).collect();
    assert!(fills.len() > 15, "{} colours", fills.len());
    assert!(texts(&document).iter().any(|t| t.contains("exaggerated") && t.contains("times")));
    assert!(figures::stress(&picture, 99).is_none());
}

#[test]
fn the_load_path_is_drawn_to_scale_with_unsettled_steps_hollow() {
    let mut picture = sample::arch();
    // Keep the last step on the chart.
    picture.path.last_mut().unwrap().displacement = [0.0, -0.06];
    let svg = figures::load_displacement(&picture).unwrap();
    let document = Document::parse(&svg).unwrap();
    let marks: Vec<Node> = classed(&document, "circle", "point").into_iter().filter(|n| !in_key(n)).collect();
    assert_eq!(marks.len(), picture.path.len());
    let hollow: Vec<&Node> = marks.iter().filter(|n| n.attribute("fill") == Some("white")).collect();
    assert_eq!(hollow.len(), 1);
    // The height of the last stable mark, read off between the ticks of 0 and 250 kN/m.
    let tick = |text: &str| {
        let node = document.descendants().filter(|n| n.has_tag_name("text") && n.text() == Some(text));
        node.filter(|n| n.attribute("text-anchor") == Some("end")).map(|n| number(&n, "y")).next().unwrap()
    };
    let (zero, top) = (tick("0"), tick("250"));
    let ring = classed(&document, "circle", "marked").into_iter().find(|n| !in_key(n)).unwrap();
    // Tick texts stand 4.4 units below their tick.
    let read = (zero - 4.4 - number(&ring, "cy")) / (zero - top) * 250.0;
    let stable = picture.path.iter().rfind(|s| s.at_rest).unwrap().load / 1e3;
    assert!((read - stable).abs() < 0.05, "read {read}, true {stable}");
    assert!(texts(&document).iter().any(|t| t == "last stable: 204.8 kN/m"), "{:?}", texts(&document));
}

fn in_key(node: &Node) -> bool {
    node.ancestors().any(|n| n.attribute("class") == Some("key"))
}

#[test]
fn the_envelope_marks_the_least_value_of_all_curves() {
    let sweeps = sample::sweeps();
    let svg = figures::envelope("Sweep", figures::Ordinate::Factor, &sweeps, None).unwrap();
    let document = Document::parse(&svg).unwrap();
    let least = sweeps.iter().flat_map(|s| &s.points).map(|p| p.1).fold(f64::MAX, f64::min);
    let words = texts(&document);
    assert!(words.iter().any(|t| t.starts_with(&format!("governing: {least:.4}"))), "{words:?}");
    // Gaps at both ends take nothing from the curves in between.
    assert_eq!(classed(&document, "polyline", "sweep").len(), 2);
    let nothing = figures::Sweep { label: String::new(), points: vec![(0.0, f64::INFINITY)] };
    assert!(figures::envelope("Nothing", figures::Ordinate::Factor, &[nothing], None).is_none());
}

#[test]
fn collapse_shows_the_bridge_as_built_first_and_the_end_last() {
    let svg = figures::collapse_frames(&sample::arch()).unwrap();
    let document = Document::parse(&svg).unwrap();
    assert_eq!(classed(&document, "g", "panel").len(), 6);
    let words = texts(&document);
    assert!(words.iter().any(|t| t == "(a) as built"));
    assert!(words.iter().any(|t| t.starts_with("(b)") && t.ends_with("last stable")));
    assert!(words.iter().any(|t| t.starts_with("(f)") && t.ends_with("5 of 5")), "{words:?}");
}

#[test]
fn small_motions_are_exaggerated_and_none_are_not_drawn() {
    let mut picture = sample::arch();
    picture.snapshots.truncate(4);
    let svg = figures::collapse_frames(&picture).unwrap();
    assert!(texts(&Document::parse(&svg).unwrap()).iter().any(|t| t.contains("exaggerated")));
    picture.snapshots.truncate(1);
    picture.last_stable = Some(0);
    assert!(figures::collapse_frames(&picture).is_none());
}

#[test]
fn where_hinges_are_many_labels_give_way_to_the_drawing() {
    let mut picture = sample::arch();
    picture.hinges = (0..30).map(|k| Hinge { point: picture.shapes[k].outline[3], ..picture.hinges[0] }).collect();
    let svg = figures::mechanism(&picture).unwrap();
    let document = Document::parse(&svg).unwrap();
    assert_eq!(classed(&document, "circle", "hinge").len(), 30);
    assert!(!texts(&document).iter().any(|t| t.ends_with(" intrados")));
}

#[test]
fn what_there_is_no_material_for_is_not_drawn() {
    let empty = Picture::default();
    let names: Vec<String> = figures::drawings(&empty).into_iter().map(|d| d.0).collect();
    assert_eq!(names, ["bridge"]);
    let block = sample::single_block();
    let names: Vec<String> = figures::drawings(&block).into_iter().map(|d| d.0).collect();
    assert_eq!(names, ["bridge", "mechanism"]);
}

#[test]
fn results_that_are_not_numbers_and_lists_that_do_not_fit_do_no_harm() {
    let mut picture = sample::arch();
    picture.shapes[5].outline[0] = [f64::NAN, f64::INFINITY];
    picture.snapshots[3].stresses[7] = [f64::NAN; 3];
    picture.snapshots[3].contacts[0].blocks = [9999, 9999];
    picture.snapshots[4].motions.truncate(3);
    picture.snapshots[5].velocities.clear();
    picture.path[2].displacement = [f64::NAN; 2];
    picture.hinges.push(Hinge {
        point: [f64::NAN; 2],
        edge: HingeAt::Other,
        between: [usize::MAX; 2],
        rotation: f64::NAN,
    });
    picture.thrust_lines[0][4].point = [f64::NAN; 2];
    picture.loads[0].force = [f64::NAN; 2];
    picture.surface_loads.push(([f64::NAN; 2], f64::NAN));
    for (name, svg) in figures::drawings(&picture) {
        Document::parse(&svg).unwrap();
        assert!(!svg.contains("NaN") && !svg.contains("inf\""), "{name}");
    }
    assert!(sample::all(&picture).is_ok());
}

#[test]
fn the_tornado_has_the_widest_bar_on_top_and_names_both_ends() {
    let study = sample::studies::usual();
    let svg = figures::tornado(&study).unwrap();
    let document = Document::parse(&svg).unwrap();
    let words = texts(&document);
    let place =
        |word: &str| words.iter().position(|text| text == word).unwrap_or_else(|| panic!("{word} in {words:?}"));
    assert!(place("joint.tensile_strength") < place("span[1].ring[2].springing_thickness"));
    assert!(place("span[1].ring[2].springing_thickness") < place("joint.friction_angle"));
    for text in ["90 kPa: +45.0 %", "0.65 m: −19.9 %", "not in the file", "2100 kg/m³", "viscous: +2.0 %"] {
        place(text);
    }
    place("5 deg: not-converged");
    place("0.1 m: unstable-under-self-weight");
    place("adaptive: stalled");
    // Bars are as long as the change they show: 90 kN/m against 0.23·200 kN/m.
    let width = |bar: &Node| {
        let x: Vec<f64> = points(bar).iter().map(|p| p[0]).collect();
        x.iter().copied().fold(f64::NEG_INFINITY, f64::max) - x.iter().copied().fold(f64::INFINITY, f64::min)
    };
    let bars = classed(&document, "polygon", "swing");
    let change = 200.0 * ((0.75_f64 / 0.7).powi(3) - 1.0);
    // Coordinates have two decimals.
    assert!(
        (width(&bars[0]) / width(&bars[2]) - 90.0 / change).abs() < 2e-3,
        "{} {}",
        width(&bars[0]),
        width(&bars[2])
    );
}

#[test]
fn curves_mark_runs_that_ended_otherwise_and_heat_maps_count_their_cells() {
    let study = sample::studies::usual();
    let svg = figures::response(&study, 0).unwrap();
    let document = Document::parse(&svg).unwrap();
    assert_eq!(classed(&document, "polyline", "without").len(), 2, "one cross");
    assert!(texts(&document).contains(&"not-converged".to_owned()));
    assert_eq!(classed(&document, "circle", "marked").len(), 1, "the file's own value");
    assert!(figures::response(&study, 2).is_none(), "words have no axis");
    let grid = figures::heat_map(&sample::studies::grid()).unwrap();
    let document = Document::parse(&grid).unwrap();
    assert_eq!(classed(&document, "polygon", "cell").len(), 12);
    assert_eq!(classed(&document, "polygon", "baseline").len(), 1);
    let names: Vec<String> = figures::study_drawings(&study).into_iter().map(|(name, _)| name).collect();
    assert_eq!(names[..2], ["tornado", "curve-joint-friction_angle"]);
    assert!(figures::study_drawings(&sample::studies::without_answer()).is_empty());
}

#[test]
fn particles_that_are_not_numbers_and_forces_between_nobody_do_no_harm() {
    let mut picture = sample::filled();
    let stable = picture.last_stable.unwrap();
    let state = &mut picture.snapshots[stable];
    state.particles[3].centre = [f64::NAN, 1.0];
    state.particles[4].centre = [1e300, -1e300];
    state.particles[5].stress = [f64::NAN; 3];
    state.particle_forces[0].compression = f64::NAN;
    state.particle_forces[1].particle = 1_000_000;
    state.particle_forces[2].partner = Partner::Particle(1_000_000);
    state.particle_forces[3].partner = Partner::Shape(1_000_000);
    picture.particles[6].centre = [f64::INFINITY; 2];
    picture.particles[7].layer = usize::MAX;
    picture.snapshots[stable + 1].particles.truncate(9);
    picture.fill[2] = [f64::NAN; 2];
    for (name, svg) in figures::drawings(&picture) {
        Document::parse(&svg).unwrap();
        assert!(!svg.contains("NaN") && !svg.contains("inf\""), "{name}");
    }
    assert!(sample::all(&picture).is_ok());
    picture.snapshots[0].particles.clear();
    assert!(figures::displacement(&picture).is_none());
    picture.snapshots.clear();
    assert!(figures::force_chains(&picture).is_none() && figures::packing(&picture).is_some());
    picture.particles.clear();
    assert!(figures::packing(&picture).is_none());
}

#[test]
fn every_particle_is_drawn_once_in_each_panel() {
    let picture = sample::filled();
    let count = |svg: &str| svg.matches("<circle").count();
    let particles = picture.particles.len();
    let hinges = picture.hinges.len();
    assert_eq!(count(&figures::bridge_as_drawn(&picture)), particles);
    assert_eq!(count(&figures::packing(&picture).unwrap()), 2 * particles);
    assert_eq!(count(&figures::displacement(&picture).unwrap()), 2 * particles);
    assert_eq!(count(&figures::fill_stress(&picture).unwrap()), 2 * particles);
    assert_eq!(count(&figures::force_chains(&picture).unwrap()), particles);
    assert_eq!(count(&figures::collapse_frames(&picture).unwrap()), 6 * particles);
    assert_eq!(count(&figures::mechanism(&picture).unwrap()), particles + hinges + 1);
}

#[test]
fn force_chains_are_as_wide_as_their_force_is_large() {
    let picture = sample::filled();
    let svg = figures::force_chains(&picture).unwrap();
    let document = Document::parse(&svg).unwrap();
    // The hatching of supports is a path as well.
    let is_hatch = |n: &Node| n.parent_element().and_then(|parent| parent.attribute("class")) == Some("hatch");
    let paths: Vec<Node> = document.descendants().filter(|n| n.has_tag_name("path") && !is_hatch(n)).collect();
    let lines: usize = paths.iter().map(|p| p.attribute("d").unwrap().matches('M').count()).sum();
    let forces = &picture.snapshots[picture.last_stable.unwrap()].particle_forces;
    assert_eq!(lines, forces.len());
    // The one contact with the block carries most and is alone in the widest path.
    let widest = paths.iter().map(|p| number(p, "stroke-width")).fold(0.0, f64::max);
    let last = paths.iter().find(|p| number(p, "stroke-width") == widest).unwrap();
    assert_eq!(last.attribute("d").unwrap().matches('M').count(), 1);
}

#[test]
fn twenty_thousand_particles_stay_within_some_megabytes() {
    let mut picture = sample::filled();
    let times = 20_000usize.div_ceil(picture.particles.len());
    let grow = |list: &mut Vec<outcome::picture::DiscState>| *list = list.repeat(times);
    picture.snapshots.iter_mut().for_each(|s| grow(&mut s.particles));
    picture.particles = std::iter::repeat_n(picture.particles.clone(), times).flatten().collect();
    picture.particles.iter_mut().for_each(|d| d.radius *= 0.2);
    for (name, svg) in figures::drawings(&picture) {
        assert!(svg.len() < 4_000_000, "{name}: {} bytes", svg.len());
    }
}

/// Names of the figures that only soil has.
const OF_SOIL: [&str; 3] = ["soil-mechanism", "soil-stress", "soil-pressure"];

#[test]
fn no_figure_of_soil_without_soil() {
    let with: Vec<String> =
        figures::drawings(&sample::soils::two_triangles()).into_iter().map(|(name, _)| name).collect();
    assert!(OF_SOIL.iter().all(|name| with.iter().any(|n| n == name)), "{with:?}");
    for (name, mut picture) in sample::every() {
        picture.soil = None;
        for (kind, svg) in figures::drawings(&picture) {
            assert!(!kind.starts_with("soil") && !svg.contains("class=\"soil"), "{name}/{kind}");
        }
    }
}

#[test]
fn slip_is_coloured_and_what_stands_is_one_pale_outline() {
    let picture = sample::soils::two_triangles();
    let svg = figures::soil_mechanism(&picture).unwrap();
    let document = Document::parse(&svg).unwrap();
    // One of the two triangles dissipates.
    let slips = classed(&document, "path", "slip");
    assert_eq!(slips.len(), 1);
    assert_eq!(slips[0].attribute("d").unwrap().matches('M').count(), 1);
    let outlines = classed(&document, "path", "soil-outline");
    assert_eq!(outlines[0].attribute("d").unwrap().split(' ').count(), 8, "four corners");
    assert_eq!(classed(&document, "polyline", "plate").len(), 1);
    assert!(texts(&document).iter().any(|t| t.ends_with("at collapse, 12 kN/m")), "{:?}", texts(&document));
    // The soil is moved in the scale of the blocks: its lower side half as far as the block.
    let corner = |d: &str| -> f64 { d[1..].split(' ').next().unwrap().parse().unwrap() };
    let ghost = classed(&document, "path", "soil-ghost")[0].attribute("d").unwrap().to_owned();
    let of_soil = corner(outlines[0].attribute("d").unwrap()) - corner(&ghost);
    let of_block = points(&classed(&document, "polygon", "block")[0])[0][0]
        - points(&classed(&document, "polygon", "ghost")[0])[0][0];
    // All rounded to a hundredth of a unit.
    assert!(of_block > 5.0 && (of_soil - 0.5 * of_block).abs() < 0.03, "{of_soil} {of_block}");
}

#[test]
fn the_largest_pressure_is_named_and_drawn_to_its_scale() {
    let picture = sample::soils::two_triangles();
    let svg = figures::soil_pressure(&picture).unwrap();
    let document = Document::parse(&svg).unwrap();
    let words = texts(&document);
    assert!(words.iter().any(|t| t == "20 kPa"), "{words:?}");
    assert!(words.iter().any(|t| t.contains("Largest pressure: 20 kPa. Largest shear stress: 3 kPa.")), "{words:?}");
    // The bar stands for the largest round pressure, here the largest itself; the mark of that stands as high over the back.
    let bar = points(&classed(&document, "polyline", "pressure-bar")[0]);
    let back = points(&classed(&document, "polygon", "block")[0])[2];
    let mark = &classed(&document, "circle", "largest")[0];
    assert!((back[1] - number(mark, "cy") - (bar[0][1] - bar[1][1])).abs() < 0.03);
    // Shear on the block is negative: against the way from the first end to the second.
    let arrow = points(&classed(&document, "polyline", "shear")[0]);
    assert!(arrow[1][0] < arrow[0][0]);
}

#[test]
fn principal_stresses_press_or_pull_and_are_told_apart() {
    let path = |picture: &Picture, class: &str| {
        let svg = figures::soil_stress(picture).unwrap();
        let document = Document::parse(&svg).unwrap();
        let count = |n: Node| n.children().filter_map(|p| Some(p.attribute("d")?.matches('M').count())).sum::<usize>();
        (classed(&document, "g", class).into_iter().map(count).sum::<usize>(), texts(&document))
    };
    let mut picture = sample::soils::two_triangles();
    let (pressing, words) = path(&picture, "compression");
    assert!(pressing > 200 && !words.contains(&"tension".to_owned()), "{pressing}");
    assert_eq!(path(&picture, "tension").0, 0);
    picture.soil.as_mut().unwrap().stresses = vec![[[5e3, -20e3, 0.0]; 3]; 2];
    let (pulling, words) = path(&picture, "tension");
    // Each with a short bar at both ends.
    assert_eq!(pulling, 3 * path(&picture, "compression").0);
    assert!(words.contains(&"tension".to_owned()) && words.contains(&"20 kPa".to_owned()), "{words:?}");
}

#[test]
fn ten_thousand_triangles_stay_within_half_a_megabyte() {
    let mut picture = sample::soils::under_fill(2, 48);
    let soil = picture.soil.as_mut().unwrap();
    assert!(soil.triangles.len() > 10_000);
    // Neighbours of one class share an outline; these share none.
    soil.dissipation = (0..soil.triangles.len()).map(|t| 1.2e-3 * (1.0 + (t % 12) as f64).powi(3)).collect();
    for (name, svg) in figures::drawings(&picture) {
        assert!(svg.len() < 600_000, "{name}: {} bytes", svg.len());
    }
}

#[test]
fn soil_that_is_not_a_number_does_no_harm() {
    let mut picture = sample::soils::soiled();
    let soil = picture.soil.as_mut().unwrap();
    soil.points[3] = [f64::NAN, 1.0];
    soil.points[4] = [1e300, 1.0];
    soil.motions[70] = [f64::INFINITY, 0.0];
    soil.stresses[9] = [[f64::NAN; 3]; 3];
    soil.dissipation[5] = f64::NAN;
    soil.pressures[2].pressure = [f64::NAN; 2];
    soil.pressures[3].ends = [[0.0; 2]; 2];
    soil.plates[0].motions[0] = [f64::NAN; 2];
    for (name, svg) in figures::drawings(&picture) {
        Document::parse(&svg).unwrap();
        assert!(!svg.contains("NaN") && !svg.contains("inf"), "{name}");
    }
    let soil = picture.soil.as_mut().unwrap();
    soil.stresses.pop();
    soil.dissipation.clear();
    soil.pressures.clear();
    let names: Vec<String> = figures::drawings(&picture).into_iter().map(|d| d.0).collect();
    assert!(!names.iter().any(|n| n.starts_with("soil")), "{names:?}");
    picture.soil.as_mut().unwrap().triangles[0] = [0, 1, usize::MAX];
    assert!(figures::vtk::soil(&picture).is_none());
    assert!(figures::mechanism(&picture).is_some());
}
