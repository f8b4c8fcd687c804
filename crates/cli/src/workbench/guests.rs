//! Who is connected. There are so many places; who comes when all are taken gets that of the connection that has been of no use for
//! longest, so that connections which say nothing keep nobody out.

use std::sync::Arc;
use std::sync::atomic::{AtomicU64, Ordering};
use tokio::task::AbortHandle;

/// The connections that are open.
#[derive(Default)]
pub(super) struct Guests {
    list: Vec<Guest>,
    /// Connections and requests are counted together: a larger number is later.
    count: Arc<AtomicU64>,
}

struct Guest {
    came: u64,
    use_of: Use,
    handle: AbortHandle,
}

/// When a connection last asked for something; never, at first.
#[derive(Clone)]
pub(super) struct Use {
    last: Arc<AtomicU64>,
    count: Arc<AtomicU64>,
}

impl Use {
    /// A request came.
    pub(super) fn asked(&self) {
        self.last.store(self.count.fetch_add(1, Ordering::Relaxed) + 1, Ordering::Relaxed);
    }
}

impl Guests {
    /// What a new connection tells of itself.
    pub(super) fn announced(&self) -> Use {
        Use { last: Arc::default(), count: Arc::clone(&self.count) }
    }

    /// Makes room among `most` places, by ending the connection that asked for nothing, or asked longest ago.
    pub(super) fn make_room(&mut self, most: usize) {
        self.list.retain(|guest| !guest.handle.is_finished());
        while self.list.len() >= most {
            let idle = |guest: &Guest| (guest.use_of.last.load(Ordering::Relaxed), guest.came);
            let Some(place) = (0..self.list.len()).min_by_key(|place| idle(&self.list[*place])) else { return };
            self.list.swap_remove(place).handle.abort();
        }
    }

    /// A connection has a place from now on.
    pub(super) fn seat(&mut self, use_of: Use, handle: AbortHandle) {
        let came = self.count.fetch_add(1, Ordering::Relaxed) + 1;
        self.list.push(Guest { came, use_of, handle });
    }
}
