//! Where blocks came from.

use mechanics::plane::Vec2;

/// Where a block came from. Spans, rings and supports count from 0, supports from the left.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Origin {
    /// A voussoir, counted from the left springing.
    Voussoir {
        /// Span.
        span: usize,
        /// Ring, from the intrados up.
        ring: usize,
        /// Voussoir.
        voussoir: usize,
    },
    /// The fixed block behind a springing.
    Abutment {
        /// Support: 0 or the last.
        support: usize,
    },
    /// The fixed block below a pier.
    Foundation {
        /// Support.
        support: usize,
    },
    /// A course of a pier.
    Pier {
        /// Support.
        support: usize,
        /// Course, from the foundation up.
        course: usize,
    },
    /// The ground under an abutment that can move.
    AbutmentGround {
        /// Support: 0 or the last.
        support: usize,
    },
    /// A course of an abutment that can move.
    AbutmentCourse {
        /// Support: 0 or the last.
        support: usize,
        /// Course, from the ground up.
        course: usize,
    },
    /// A block of a model that is no bridge, counted from 0.
    Block {
        /// Its place among the blocks.
        number: usize,
    },
    /// A brick of a spandrel wall, or a piece of one that was cut.
    Brick {
        /// Course, from the top; none for the stones of steep haunches.
        course: Option<usize>,
        /// Counted through all courses, from the left.
        brick: usize,
    },
    /// A stone of the backing, or a column of it on the back of a voussoir.
    Backing {
        /// Counted from the left.
        column: usize,
    },
    /// A slab of a layer that lies on particles.
    Slab {
        /// Layer, from the extrados up.
        layer: usize,
        /// Counted from the left.
        slab: usize,
    },
    /// The fixed wall at an end of the spandrel wall.
    EndWall {
        /// Whether it is the right one.
        right: bool,
    },
    /// A block that brings a load onto the surface.
    LoadingBlock {
        /// The load, in the order of the file.
        load: usize,
    },
}

impl Origin {
    /// The word for drawings.
    pub fn role(self) -> &'static str {
        match self {
            Origin::Voussoir { .. } => "voussoir",
            Origin::Abutment { .. } | Origin::Foundation { .. } | Origin::AbutmentGround { .. } => "abutment",
            Origin::Pier { .. } | Origin::AbutmentCourse { .. } => "pier",
            Origin::Brick { .. } | Origin::EndWall { .. } => "wall",
            Origin::Block { .. } | Origin::LoadingBlock { .. } | Origin::Slab { .. } => "block",
            Origin::Backing { .. } => "backing",
        }
    }
    /// Whether it is part of the arches and what they stand on, and not of what stands on them.
    pub fn is_arch(self) -> bool {
        matches!(self.role(), "voussoir" | "abutment" | "pier")
    }
    /// A name for tables and messages, counted from 1.
    pub fn name(self) -> String {
        let side = |support: usize| if support == 0 { "left" } else { "right" };
        match self {
            Origin::Voussoir { span, ring, voussoir } => {
                format!("span {} ring {} voussoir {}", span + 1, ring + 1, voussoir + 1)
            }
            Origin::Abutment { support } => format!("{} abutment", side(support)),
            Origin::Foundation { support } => format!("foundation of pier {support}"),
            Origin::Pier { support, course } => format!("pier {support} course {}", course + 1),
            Origin::AbutmentGround { support } => format!("ground under the {} abutment", side(support)),
            Origin::AbutmentCourse { support, course } => format!("{} abutment course {}", side(support), course + 1),
            Origin::Block { number } => format!("block {}", number + 1),
            Origin::Brick { course: Some(course), brick } => format!("wall course {} brick {}", course + 1, brick + 1),
            Origin::Brick { course: None, brick } => format!("wall haunch stone {}", brick + 1),
            Origin::EndWall { right } => format!("{} end wall", side(usize::from(right))),
            Origin::Backing { column } => format!("backing column {}", column + 1),
            Origin::Slab { layer, slab } => format!("layer {} slab {}", layer + 1, slab + 1),
            Origin::LoadingBlock { load } => format!("block of load {}", load + 1),
        }
    }
}

/// The lower and upper face of a voussoir, each from left to right [m].
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Faces {
    /// Towards the intrados.
    pub bed: [Vec2; 2],
    /// Towards the extrados.
    pub back: [Vec2; 2],
}
