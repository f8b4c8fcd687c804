//! Why a bridge cannot be cut into blocks.

use super::wall::WallError;
use bridge::ring::Misfit;
use mechanics::plane::PolygonError;
use thiserror::Error;

/// Why a bridge cannot be cut into blocks.
#[derive(Debug, Clone, PartialEq, Error)]
#[expect(missing_docs, reason = "the messages say what each is")]
pub enum DiscretiseError {
    #[error("voussoir {voussoir} of ring {ring} in span {span} has no usable outline: {source}")]
    Voussoir { span: usize, ring: usize, voussoir: usize, source: PolygonError },
    #[error("support {support} (0 is the left abutment) has no usable outline: {source}")]
    Support {
        /// Support, from the left, 0 the left abutment.
        support: usize,
        source: PolygonError,
    },
    #[error("the rings on both sides of pier {support} cross by {overlap:.3} m: its width of {width} m is too small")]
    RingsCross {
        support: usize,
        /// By how much [m].
        overlap: f64,
        /// Width of the pier [m].
        width: f64,
    },
    /// The intrados of a span cannot be drawn.
    #[error("the intrados of span {span} has no curve: {misfit}")]
    Intrados {
        /// Span, from 1.
        span: usize,
        /// Why.
        misfit: Misfit,
    },
    /// The spandrel wall cannot be cut into bricks.
    #[error(transparent)]
    Wall(#[from] WallError),
    #[error("backing cannot be laid as blocks on these haunches: {0}; write as = \"weight\" in [backing]")]
    Backing(WallError),
    #[error("the bridge has no spandrel wall: describe it with [spandrel_wall], or analyse strip = \"fill\"")]
    NoWall,
    #[error(
        "load {load} stands on cover that is weight alone and cannot carry its block: write through = \"cover\", or analyse \
         strip = \"wall\""
    )]
    BlockOnCover { load: usize },
    #[error(
        "layer {layer} of the cover is weight alone, and weight cannot act on particles: write as = \"particles\" or as = \
         \"nothing\" for it"
    )]
    WeightOnParticles { layer: usize },
    #[error("[backing] is weight alone and cannot carry particles: leave it out, or model no layer as particles")]
    BackingUnderParticles,
    #[error("load {load} would act on particles: write through = \"block\" and the block's weight")]
    LoadOnParticles { load: usize },
    #[error(
        "layer {layer} of the cover cannot lie on the one below it: from the extrados up come particles, then blocks, then \
         what is weight alone or nothing"
    )]
    LayerOrder { layer: usize },
    #[error("there is no region between the extrados and the road that particles could fill")]
    NoRegion,
    #[error(
        "the continuum is {depth:.3} m thick over the crown and loads would stand on the ring: give its layers a greater thickness"
    )]
    ContinuumWithoutDepth {
        /// Thickness over the crown [m].
        depth: f64,
    },
    #[error(
        "a load at {x:.3} m is {length:.3} m long: a point load on a continuum is carried by nothing; give contact_length, or the \
         length of the load"
    )]
    PointLoadOnContinuum {
        /// Its middle [m].
        x: f64,
        /// Its length along the bridge [m].
        length: f64,
    },
    #[error(
        "the support has moved before the loads came, and only single rings without walls, particles or a continuum are brought into their \
         new shape: leave out `before` of [support_movement], and describe the shape that was surveyed with profile = \"measured\""
    )]
    MovedShape,
    #[error(
        "the bridge falls before its support has moved by {before:.4} m: it stands up to {stands:.4} m; check `before` of \
         [support_movement], the thickness of the ring and what lies above it"
    )]
    FellBefore {
        /// Movement of the file [m].
        before: f64,
        /// Largest movement at which it stands [m].
        stands: f64,
    },
    #[error("a load acts along the bridge, and {what} knows vertical loads only: leave out `horizontal` and `braking`")]
    Horizontal {
        /// What knows vertical loads only.
        what: &'static str,
    },
    #[error(
        "the road is not level, and {what} knows none but a level one: leave out [road] and give the lowest layer its least thickness, or \
         write as = \"weight\""
    )]
    RoadNotLevel {
        /// What asks for a level road.
        what: &'static str,
    },
    #[error(
        "the road is not level, and a spandrel wall has courses up to one level: give its `top` in [spandrel_wall]"
    )]
    WallUnderRoad,
    #[error(
        "the springings are not level, and {what} reaches up to one level: write as = \"weight\" in [backing], whose level then follows the \
         springings"
    )]
    SpringingsNotLevel {
        /// What asks for level springings.
        what: &'static str,
    },
    #[error(
        "{part} takes the place of cover that is weight, and {what} is a body: model the cover as weight, or leave {part} out and give the \
         layers mean densities"
    )]
    Hollow {
        /// What is hollow.
        part: &'static str,
        /// How the cover is modelled.
        what: &'static str,
    },
    #[error(
        "an abutment of blocks can move, and {what} bears on ground that cannot: write as = \"fixed\" in [abutment], or model the cover as \
         weight"
    )]
    MovableAbutment {
        /// How the cover is modelled.
        what: &'static str,
    },
    #[error(
        "void {void} reaches into the ring: at x = {x:.3} m the extrados lies {above:.3} m above its roof; give a higher `roof`, or end it \
         before that place"
    )]
    VoidInRing {
        /// Void, from 1, from the left.
        void: usize,
        /// Where [m].
        x: f64,
        /// By how much [m].
        above: f64,
    },
    #[error(
        "the roof of void {void} lies above the lowest layer of the cover, whose top is at {top:.3} m there: give a lower `roof`"
    )]
    VoidAboveFill {
        /// Void, from 1, from the left.
        void: usize,
        /// Level of the layer's top [m].
        top: f64,
    },
    #[error(
        "the roof of void {void} is carried to x = {x:.3} m, where nothing of the bridge stands: give places between the ends of the \
         abutments in `carried_to`"
    )]
    VoidBesideBridge {
        /// Void, from 1, from the left.
        void: usize,
        /// Where [m].
        x: f64,
    },
    #[error("support {support} does not exist: the last is {last}")]
    NoSuchSupport {
        /// Support named.
        support: usize,
        /// The right abutment.
        last: usize,
    },
}
