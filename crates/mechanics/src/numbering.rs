//! In which order the equations of blocks stand, so that those of neighbours are near one another.

/// An equation number that stands for a prevented motion.
pub(crate) const HELD: u32 = u32::MAX;

/// Equations of the free motions, block by block from neighbour to neighbour (blocks that act on one another), so that the band is narrow (Cuthill and McKee
/// 1969); and of each equation the last one that it acts with: those of its own block, and of the blocks that act on it.
pub(crate) fn numbered(held: &[[bool; 3]], pairs: &[[usize; 2]]) -> (Vec<[u32; 3]>, Vec<u32>) {
    let mut neighbours: Vec<Vec<usize>> = vec![Vec::new(); held.len()];
    let free = |i: usize| held[i] != [true; 3];
    for &[a, b] in pairs.iter().filter(|pair| pair.iter().all(|&block| free(block))) {
        neighbours[a].push(b);
        neighbours[b].push(a);
    }
    let degrees: Vec<usize> = neighbours.iter().map(Vec::len).collect();
    for list in &mut neighbours {
        list.sort_unstable_by_key(|&j| (degrees[j], j));
    }
    let mut order = Vec::new();
    let mut seen = vec![false; held.len()];
    let mut starts: Vec<usize> = (0..held.len()).filter(|&i| free(i)).collect();
    starts.sort_by_key(|&i| (degrees[i], i));
    for start in starts {
        if seen[start] {
            continue;
        }
        // From the far end of the part that the block belongs to.
        let from = *breadth_first(start, &neighbours, &mut seen.clone()).last().expect("it begins with the start");
        order.extend(breadth_first(from, &neighbours, &mut seen));
    }
    let mut equation = vec![[HELD; 3]; held.len()];
    let mut count = 0;
    for block in order {
        for c in 0..3 {
            if !held[block][c] {
                equation[block][c] = count;
                count += 1;
            }
        }
    }
    let mut last = vec![0; count as usize];
    let own = (0..equation.len()).map(|block| [block, block]);
    for [first, second] in own.chain(pairs.iter().copied()) {
        let both: Vec<u32> = equation[first].iter().chain(&equation[second]).copied().filter(|&e| e != HELD).collect();
        let most = both.iter().copied().max().unwrap_or(0);
        both.iter().for_each(|&e| last[e as usize] = most.max(last[e as usize]));
    }
    (equation, last)
}

fn breadth_first(start: usize, neighbours: &[Vec<usize>], seen: &mut [bool]) -> Vec<usize> {
    let mut order = vec![start];
    seen[start] = true;
    let mut next = 0;
    while next < order.len() {
        for &j in &neighbours[order[next]] {
            if !seen[j] {
                seen[j] = true;
                order.push(j);
            }
        }
        next += 1;
    }
    order
}
