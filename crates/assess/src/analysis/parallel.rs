//! Pieces of work on all cores under one onlooker: progress out, a wish to stop in, and what is done is kept.

pub(crate) use mechanics::watch::CancelToken;
use mechanics::watch::{Progress, Watch, Wish};
use std::sync::mpsc::{RecvTimeoutError, Sender, TryRecvError, channel};
use std::time::Duration;

/// How long the onlooker waits between two looks at most.
const LOOK: Duration = Duration::from_millis(20);

/// What the onlooker is told of a stage.
pub(crate) struct Stage<'a> {
    /// In a few words.
    pub name: &'a str,
    /// Steps that its pieces count in all.
    pub steps: u64,
    /// Shares of the whole work at which the stage begins and ends.
    pub shares: [f64; 2],
}

/// Does `work` on every job; answers come in the order of the jobs. When the onlooker wishes to stop, jobs that are not
/// begun are left out, and those at work hear it from their [`CancelToken`]. Tells whether all of it was done.
pub(crate) fn each<J: Sync, T: Send>(
    jobs: &[J],
    stage: &Stage<'_>,
    watch: &mut dyn Watch,
    work: impl Fn(&J, &CancelToken) -> T + Sync,
) -> (Vec<Option<T>>, bool) {
    let token = CancelToken::default();
    let mut found: Vec<Option<T>> = jobs.iter().map(|_| None).collect();
    let mut look = || {
        looked(&token, watch, || {
            let done = token.steps();
            let share = (done as f64 / stage.steps.max(1) as f64).clamp(0.0, 1.0);
            let [from, to] = stage.shares;
            let name = format!("{}: {done} of {}", stage.name, stage.steps);
            Progress { stage: name, fraction: Some(from + share * (to - from)), steps: done }
        });
    };
    look();
    let mut hear = |said: Option<(usize, T)>| {
        if let Some((k, answer)) = said {
            found[k] = Some(answer);
        }
        look();
    };
    told(jobs, &mut hear, |k, job, tell| {
        if !token.is_cancelled() {
            // Nobody listens only where this function itself is gone.
            let _ = tell.send((k, work(job, &token)));
        }
    });
    let all = !token.is_cancelled();
    (found, all)
}

/// Tells the onlooker how far the work of a token is, as long as it goes on, and ends it where that is wished.
fn looked(token: &CancelToken, watch: &mut dyn Watch, progress: impl FnOnce() -> Progress) {
    if !token.is_cancelled() && watch.look(&progress()) == Wish::Stop {
        token.cancel();
    }
}

/// Does one piece of work while the onlooker hears from time to time how many iterations it has taken. The work hears from its [`CancelToken`]
/// when to stop; where it is the `whole` of an analysis, its share is told. It gets a thread of its own; where none can be started, as in WebAssembly, it is done here and in one go.
pub(crate) fn alone<T: Send>(
    name: &str,
    whole: bool,
    watch: &mut dyn Watch,
    work: impl Fn(&CancelToken) -> T + Sync,
) -> T {
    let token = CancelToken::default();
    let mut look = || {
        looked(&token, watch, || {
            let (iterations, fraction) = (token.iterations(), whole.then(|| token.share()));
            Progress { stage: format!("{name}: {iterations} iterations"), fraction, steps: iterations }
        });
    };
    look();
    let found = std::thread::scope(|scope| {
        let (tell, heard) = channel();
        let (work, token) = (&work, &token);
        // Nobody listens only where this function itself is gone.
        let own = move || drop(tell.send(work(token)));
        let Ok(_) = std::thread::Builder::new().spawn_scoped(scope, own) else { return None };
        loop {
            match heard.recv_timeout(LOOK) {
                Ok(found) => return Some(found),
                Err(RecvTimeoutError::Timeout) => look(),
                Err(RecvTimeoutError::Disconnected) => return None,
            }
        }
    });
    found.unwrap_or_else(|| work(&token))
}

/// Does `work` on every job, on all threads; `hear` gets on this one what the jobs tell, and nothing from time to time. Where
/// no threads can be started, as in WebAssembly, the pool is this thread, and it does one job after the other.
pub(crate) fn told<J: Sync, M: Send>(
    jobs: &[J],
    hear: &mut dyn FnMut(Option<M>),
    work: impl Fn(usize, &J, &Sender<M>) + Sync,
) {
    let (tell, heard) = channel();
    rayon::in_place_scope(|scope| {
        for (k, job) in jobs.iter().enumerate() {
            let (tell, work) = (tell.clone(), &work);
            scope.spawn(move |_| work(k, job, &tell));
        }
        drop(tell);
        loop {
            // On a thread of the pool it works with the others as long as there is work: waiting there could starve the jobs.
            let worked = rayon::yield_now() == Some(rayon::Yield::Executed);
            let next = match heard.try_recv() {
                // Waiting reads a clock, which not every platform has: only where others work.
                Err(TryRecvError::Empty) if !worked => heard.recv_timeout(LOOK).map_err(|error| match error {
                    RecvTimeoutError::Timeout => TryRecvError::Empty,
                    RecvTimeoutError::Disconnected => TryRecvError::Disconnected,
                }),
                next => next,
            };
            match next {
                Ok(said) => hear(Some(said)),
                Err(TryRecvError::Empty) => hear(None),
                Err(TryRecvError::Disconnected) => break,
            }
        }
    });
}

/// Turns a kept state into that of the whole.
type Keeping<'a> = dyn Fn(&[u8]) -> Vec<u8> + 'a;

/// An onlooker who is told of the work in other words.
pub(crate) struct Retold<'w, F> {
    /// Who looks on.
    pub watch: &'w mut dyn Watch,
    /// A kept state behind what stands in front of it; none where no state is kept.
    pub kept: Option<&'w Keeping<'w>>,
    /// How far the whole is, by what is told of the work.
    pub told: F,
}

impl<F: Fn(&Progress) -> Progress> Watch for Retold<'_, F> {
    fn look(&mut self, progress: &Progress) -> Wish {
        self.watch.look(&(self.told)(progress))
    }
    fn keep(&mut self, state: &dyn Fn() -> Vec<u8>) {
        if let Some(kept) = self.kept {
            self.watch.keep(&|| kept(&state()));
        }
    }
}

/// An onlooker of one part of the work, between two shares of the whole.
pub(crate) fn portion(watch: &mut dyn Watch, [from, to]: [f64; 2]) -> impl Watch {
    let told = move |progress: &Progress| {
        let fraction = progress.fraction.map(|share| from + share * (to - from));
        Progress { fraction, ..progress.clone() }
    };
    Retold { watch, kept: None, told }
}

#[cfg(test)]
mod tests {
    use super::*;

    struct After(u64);

    impl Watch for After {
        fn look(&mut self, progress: &Progress) -> Wish {
            if progress.steps >= self.0 { Wish::Stop } else { Wish::GoOn }
        }
    }

    fn squares(threads: usize, after: u64) -> (Vec<Option<u64>>, bool) {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        let jobs: Vec<u64> = (0..40).collect();
        let stage = Stage { name: "squares", steps: 40, shares: [0.0, 1.0] };
        pool.install(|| {
            each(&jobs, &stage, &mut After(after), |job, token| {
                std::thread::sleep(Duration::from_millis(1));
                token.step();
                job * job
            })
        })
    }

    #[test]
    fn pieces_come_in_order_on_any_number_of_threads_and_a_stop_keeps_what_is_done() {
        for threads in [1, 3] {
            let (all, done) = squares(threads, u64::MAX);
            assert!(done && all.iter().enumerate().all(|(k, found)| *found == Some((k * k) as u64)));
            let (some, done) = squares(threads, 5);
            let made = some.iter().flatten().count();
            assert!(!done && (5..40).contains(&made), "{made}");
        }
    }
}
