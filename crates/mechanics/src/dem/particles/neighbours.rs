//! Which particles may touch one another, and which blocks, until the next search. Pairs come and go; the shear that a
//! closed pair carries stays.

use super::cells::Cells;
use super::chunk::{CHUNK, Chunk, Contact, Incoming, Row};
use super::disc::Disc;
use super::laws::stiffness;
use super::lean::{Lean, nearest};
use super::{ParticleModel, each_chunk};
use crate::blocks::LawTable;
use crate::ids::GroupId;
use crate::plane::{Core, Pose, Vec2, vec2};

/// The blocks that particles may touch.
#[derive(Clone, Copy)]
pub(in crate::dem) struct Blocks<'a> {
    pub cores: &'a [Core],
    pub poses: &'a [Pose],
    pub groups: &'a [GroupId],
    pub laws: &'a LawTable,
}

/// Empty chunks for `count` particles.
pub(in crate::dem) fn chunks(count: usize) -> Vec<Chunk> {
    (0..count)
        .step_by(CHUNK)
        .map(|first| Chunk { first: first as u32, count: CHUNK.min(count - first) as u32, ..Chunk::default() })
        .collect()
}

/// Finds all pairs within `skin` [m] of touching, and merges them with the old ones.
pub(super) fn find(
    model: &ParticleModel,
    discs: &[Disc],
    chunks: &mut [Chunk],
    blocks: Blocks<'_>,
    cells: &mut Cells,
    skin: f64,
) {
    let largest = discs.iter().map(|d| d.radius).fold(0.0, f64::max);
    cells.fill(discs, 2.0 * largest + skin);
    let leans = find_leans(discs, blocks, cells, largest, skin);
    let cells = &*cells;
    each_chunk(chunks, &|chunk| find_contacts(model, discs, chunk, blocks.laws, cells, (largest, skin)));
    merge_leans(model, discs, chunks, blocks, leans);
    exchange(chunks);
}

/// Pairs of particles of which the earlier one is in this chunk.
fn find_contacts(
    model: &ParticleModel,
    discs: &[Disc],
    chunk: &mut Chunk,
    laws: &LawTable,
    cells: &Cells,
    (largest, skin): (f64, f64),
) {
    let old = std::mem::take(&mut chunk.contacts);
    let mut old = old.iter().peekable();
    let mut found: Vec<Contact> = Vec::with_capacity(old.len() + old.len() / 16);
    let (first, end) = (chunk.first, chunk.first + chunk.count);
    let mut near: Vec<u32> = Vec::with_capacity(32);
    for i in first..end {
        let a = &discs[i as usize];
        let reach = a.radius + largest + skin;
        near.clear();
        cells.within(vec2(a.x - reach, a.y - reach), vec2(a.x + reach, a.y + reach), |j| {
            if j > i {
                let b = &discs[j as usize];
                let (dx, dy, sum) = (b.x - a.x, b.y - a.y, a.radius + b.radius + skin);
                if dx * dx + dy * dy < sum * sum {
                    near.push(j);
                }
            }
        });
        near.sort_unstable();
        let one = (i - first) as u16;
        for &j in &near {
            while let Some(gone) = old.next_if(|o| (o.one, o.other()) < (one, j as usize)) {
                chunk.dissipated += 0.5 * gone.shear * gone.shear / gone.shear_stiffness;
            }
            let shear = old.next_if(|o| (o.one, o.other()) == (one, j as usize)).map_or(0.0, |o| o.shear);
            found.push(model.contact(discs, laws, (i, j), one, shear));
        }
    }
    for gone in old {
        chunk.dissipated += 0.5 * gone.shear * gone.shear / gone.shear_stiffness;
    }
    found.shrink_to_fit();
    chunk.contacts = found;
    number(chunk);
}

/// Gives every particle and block that a chunk's contacts act on a row of its forces.
fn number(chunk: &mut Chunk) {
    let (first, end) = (chunk.first, chunk.first + chunk.count);
    let mut guests: Vec<u32> = chunk.contacts.iter().map(|c| c.other() as u32).filter(|&j| j >= end).collect();
    guests.sort_unstable();
    guests.dedup();
    for contact in &mut chunk.contacts {
        let j = contact.other() as u32;
        contact.two = if j < end {
            (j - first) as u16
        } else {
            chunk.count as u16 + guests.binary_search(&j).unwrap_or_default() as u16
        };
    }
    chunk.forces.clear();
    chunk.forces.resize(chunk.count as usize + guests.len(), Row::default());
    chunk.guests = guests;
}

fn number_blocks(chunk: &mut Chunk) {
    chunk.blocks = chunk.leans.iter().map(|l| l.block).collect();
    chunk.blocks.sort_unstable();
    chunk.blocks.dedup();
    for lean in &mut chunk.leans {
        lean.row = chunk.blocks.binary_search(&lean.block).unwrap_or_default() as u32;
    }
    chunk.on_blocks = vec![[0.0; 3]; chunk.blocks.len()];
}

/// Makes the rows of chunks whose contacts were read from somewhere.
pub(in crate::dem) fn number_all(chunks: &mut [Chunk]) {
    for chunk in &mut *chunks {
        number(chunk);
        number_blocks(chunk);
    }
    exchange(chunks);
}

/// Box around a core, grown by a margin [m].
pub(in crate::dem) fn bounds(core: &Core, pose: &Pose, grow: f64) -> (Vec2, Vec2) {
    let corners = core.vertices.iter().map(|&v| pose.place(v));
    let (low, high) = crate::plane::bounds(corners.chain([pose.position]));
    (low - vec2(grow, grow), high + vec2(grow, grow))
}

/// Pairs of particle and block, with the nearest edge, sorted.
fn find_leans(discs: &[Disc], blocks: Blocks<'_>, cells: &Cells, largest: f64, skin: f64) -> Vec<(u32, u32, u32)> {
    let mut found = Vec::new();
    for (b, (core, pose)) in blocks.cores.iter().zip(blocks.poses).enumerate() {
        let (low, high) = bounds(core, pose, core.radius + largest + skin);
        cells.within(low, high, |i| {
            let disc = &discs[i as usize];
            let q = pose.rotation.turn_back(disc.centre() - pose.position);
            let (_, distance, edge) = nearest(core, q, 0);
            if distance < disc.radius + core.radius + skin {
                found.push((i, b as u32, edge as u32));
            }
        });
    }
    found.sort_unstable();
    found
}

/// Hands the leans to their chunks; those that were there before keep their shear.
fn merge_leans(
    model: &ParticleModel,
    discs: &[Disc],
    chunks: &mut [Chunk],
    blocks: Blocks<'_>,
    found: Vec<(u32, u32, u32)>,
) {
    let mut found = found.into_iter().peekable();
    for chunk in chunks {
        let old = std::mem::take(&mut chunk.leans);
        let mut old = old.iter().peekable();
        let end = chunk.first + chunk.count;
        while let Some((i, block, edge)) = found.next_if(|&(i, _, _)| i < end) {
            let local = i - chunk.first;
            while let Some(gone) = old.next_if(|o| (o.local, o.block) < (local, block)) {
                chunk.dissipated += 0.5 * gone.shear * gone.shear / gone.shear_stiffness;
            }
            chunk.leans.push(match old.next_if(|o| (o.local, o.block) == (local, block)) {
                Some(kept) => *kept,
                None => lean(model, discs, blocks, (i, block), local, edge),
            });
        }
        for gone in old {
            chunk.dissipated += 0.5 * gone.shear * gone.shear / gone.shear_stiffness;
        }
        number_blocks(chunk);
    }
}

/// A lean of a particle on a block that was not near before. It stands for the particle's diameter at a face and for the
/// mean of both diameters at a rounded corner; it keeps its length and its stiffness.
fn lean(
    model: &ParticleModel,
    discs: &[Disc],
    blocks: Blocks<'_>,
    (i, block): (u32, u32),
    local: u32,
    edge: u32,
) -> Lean {
    let (disc, core, pose) = (&discs[i as usize], &blocks.cores[block as usize], &blocks.poses[block as usize]);
    let law = blocks.laws.between(model.group(i), blocks.groups[block as usize]);
    let q = pose.rotation.turn_back(disc.centre() - pose.position);
    let (normal, distance, _) = nearest(core, q, edge as usize);
    let at_face = core.directions.iter().any(|d| normal.dot(d.right()) > 1.0 - 1e-12);
    let length = if at_face { 2.0 * disc.radius } else { disc.radius + core.radius };
    let k = stiffness(law, q.dot(normal).abs(), length);
    Lean {
        block,
        row: 0,
        local,
        edge,
        shear: 0.0,
        normal_stiffness: k.normal,
        shear_stiffness: k.shear,
        cohesion: law.cohesion * k.length,
        friction: law.friction,
        length: k.length,
        compression: k.normal * (core.radius + disc.radius - distance).max(0.0),
    }
}

/// Tells each chunk where others put the forces on its particles.
fn exchange(chunks: &mut [Chunk]) {
    chunks.iter_mut().for_each(|chunk| chunk.incoming.clear());
    for c in 0..chunks.len() {
        let (count, guests) = (chunks[c].count, std::mem::take(&mut chunks[c].guests));
        for (k, &guest) in guests.iter().enumerate() {
            let host = guest as usize / CHUNK;
            let local = guest - chunks[host].first;
            chunks[host].incoming.push(Incoming {
                chunk: c as u32,
                row: (count as usize + k) as u16,
                local: local as u16,
            });
        }
        chunks[c].guests = guests;
    }
    for chunk in chunks {
        chunk.incoming.sort_by_key(|from| (from.local, from.chunk));
    }
}
