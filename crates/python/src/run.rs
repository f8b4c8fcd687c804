//! Work away from Python: it runs on a thread of its own with a deep stack, without the interpreter's lock, while the calling thread
//! waits, hears Ctrl-C and tells how far the work is. A panic ends the work and nothing else.

use crate::errors;
use crate::kept::Kept;
use crate::options::Listener;
use extrados::{Progress, Watch, Wish};
use pyo3::exceptions::PyKeyboardInterrupt;
use pyo3::prelude::*;
use std::any::Any;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::atomic::{AtomicBool, AtomicU32, Ordering};
use std::sync::mpsc::{self, RecvTimeoutError, Sender};
use std::sync::{Arc, Mutex, Once, PoisonError};
use std::thread;
use std::time::Duration;

/// How often the waiting thread looks up.
const TICK: Duration = Duration::from_millis(20);
/// What work is given to come to an end by itself once it is asked to; after that it ends unheard.
const GRACE: Duration = Duration::from_millis(130);
/// Stack of the work: as much as the command gives it.
const STACK: usize = 32 << 20;

/// What the work and who waits for it share.
#[derive(Default)]
pub struct Shared {
    stop: AtomicBool,
    heard: bool,
    told: Mutex<Told>,
    state: Mutex<Option<Vec<u8>>>,
    has_ended: AtomicBool,
}

impl Shared {
    /// The state of the run, once its work has come to its end; Ctrl-C ends the waiting.
    pub fn state(&self, py: Python<'_>) -> PyResult<Option<Vec<u8>>> {
        while !self.has_ended.load(Ordering::Acquire) {
            py.detach(|| thread::sleep(TICK));
            py.check_signals()?;
        }
        Ok(self.state.lock().unwrap_or_else(PoisonError::into_inner).clone())
    }

    /// Whether nothing can be gone on from.
    fn is_empty(&self) -> bool {
        self.has_ended.load(Ordering::Acquire) && self.state.lock().unwrap_or_else(PoisonError::into_inner).is_none()
    }
}

#[derive(Default, Clone)]
struct Told {
    part: String,
    stage: String,
    fraction: Option<f64>,
    steps: u64,
    count: u64,
}

/// Looks on for the waiting thread.
pub(crate) struct Looker(Arc<Shared>);

impl Watch for Looker {
    fn begin(&mut self, part: &str) {
        part.clone_into(&mut self.0.told.lock().unwrap_or_else(PoisonError::into_inner).part);
    }

    fn look(&mut self, progress: &Progress) -> Wish {
        if self.0.heard
            && let Ok(mut told) = self.0.told.try_lock()
        {
            progress.stage.clone_into(&mut told.stage);
            (told.fraction, told.steps) = (progress.fraction, progress.steps);
            told.count += 1;
        }
        if self.0.stop.load(Ordering::Relaxed) { Wish::Stop } else { Wish::GoOn }
    }

    fn keep(&mut self, state: &dyn Fn() -> Vec<u8>) {
        if self.0.stop.load(Ordering::Relaxed) {
            *self.0.state.lock().unwrap_or_else(PoisonError::into_inner) = Some(state());
        }
    }
}

/// Work that came to an end, or was made to.
pub(crate) struct Finished<T> {
    /// What it gave; or why it was made to end, and what it gave where it ended in time.
    pub result: Result<T, (PyErr, Option<T>)>,
    /// What holds the state from which it can go on, at its end at the latest.
    pub shared: Arc<Shared>,
}

impl<T> Finished<T> {
    /// What it gave; an interruption leaves nothing to go on from.
    pub(crate) fn given(self, py: Python<'_>) -> PyResult<T> {
        self.result.map_err(|(cause, _)| interruption(py, cause, None, None, None))
    }
}

/// Runs `work` and waits for it.
pub(crate) fn run<T: Send + 'static>(
    py: Python<'_>,
    progress: Listener<'_, '_>,
    work: impl FnOnce(&mut Looker) -> T + Send + 'static,
) -> PyResult<Finished<T>> {
    let shared = Arc::new(Shared { heard: progress.is_some(), ..Shared::default() });
    let (sender, receiver) = mpsc::channel();
    let (own, looker_has_ended) = (Arc::clone(&shared), Arc::clone(&shared));
    hand_over(Box::new(move || {
        let mut looker = Looker(own);
        let done = catch_unwind(AssertUnwindSafe(|| in_pool(|| work(&mut looker))));
        looker_has_ended.has_ended.store(true, Ordering::Release);
        // Who waits may have gone.
        let _ = sender.send(done.map_err(|panic| panicked(&*panic)));
    }));
    let receiver = Mutex::new(receiver);
    let wait =
        |time: Duration| py.detach(|| receiver.lock().unwrap_or_else(PoisonError::into_inner).recv_timeout(time));
    let mut heard = 0;
    let interrupted = loop {
        match wait(TICK) {
            Ok(done) => return finished(py, Some(done), None, shared),
            Err(RecvTimeoutError::Disconnected) => return finished(py, None, None, shared),
            Err(RecvTimeoutError::Timeout) => {}
        }
        if let Err(error) = py.check_signals().and_then(|()| tell(progress, &shared, &mut heard)) {
            break error;
        }
    };
    shared.stop.store(true, Ordering::Relaxed);
    let done = wait(GRACE).ok();
    finished(py, done, Some(interrupted), shared)
}

fn finished<T>(
    py: Python<'_>,
    done: Option<Result<T, String>>,
    interrupted: Option<PyErr>,
    shared: Arc<Shared>,
) -> PyResult<Finished<T>> {
    let result = match (done.transpose().map_err(|words| broken(py, &words))?, interrupted) {
        (Some(result), None) => Ok(result),
        (result, Some(cause)) => Err((cause, result)),
        (None, None) => return Err(broken(py, "the thread of the work ended without an answer")),
    };
    Ok(Finished { result, shared })
}

/// Tells the callback what is new.
fn tell(progress: Listener<'_, '_>, shared: &Shared, heard: &mut u64) -> PyResult<()> {
    let Some(callback) = progress else { return Ok(()) };
    let told = shared.told.lock().unwrap_or_else(PoisonError::into_inner).clone();
    if told.count == *heard {
        return Ok(());
    }
    *heard = told.count;
    callback.call1((told.part, told.stage, told.fraction, told.steps)).map(drop)
}

/// Runs something short that needs the interpreter, and names what breaks.
pub(crate) fn guarded<T>(py: Python<'_>, work: impl FnOnce() -> T) -> PyResult<T> {
    catch_unwind(AssertUnwindSafe(work)).map_err(|panic| broken(py, &panicked(&*panic)))
}

fn broken(py: Python<'_>, words: &str) -> PyErr {
    let help = "this is a mistake in extrados: please report it with the file and the call";
    errors::of_kind(py, "internal", &[extrados::Refusal::new("F199", words, help)])
}

/// Ends an interrupted call: with `extrados.Interrupted` where the user asked, with the callback's own exception otherwise.
pub(crate) fn interruption(
    py: Python<'_>,
    cause: PyErr,
    result: Option<Bound<'_, PyAny>>,
    shared: Option<Arc<Shared>>,
    kept: Option<Arc<Kept>>,
) -> PyErr {
    if !cause.is_instance_of::<PyKeyboardInterrupt>(py) {
        return cause;
    }
    let made = || -> PyResult<PyErr> {
        let state = match (shared.filter(|shared| !shared.is_empty()), kept) {
            (None, None) => None,
            (run, kept) => Some(Bound::new(py, crate::kept::State { run, bytes: None, kept })?),
        };
        let class = py.import("extrados.errors")?.getattr("Interrupted")?;
        Ok(PyErr::from_value(class.call1((result, state))?))
    };
    made().unwrap_or_else(|error| error)
}

// ---- threads

type Job = Box<dyn FnOnce() + Send>;

/// Threads that wait for work, and whose they are: a forked process has none of its parent's.
static IDLE: Mutex<(u32, Vec<Sender<Job>>)> = Mutex::new((0, Vec::new()));

fn hand_over(job: Job) {
    let worker = {
        let mut idle = IDLE.lock().unwrap_or_else(PoisonError::into_inner);
        if idle.0 != std::process::id() {
            *idle = (std::process::id(), Vec::new());
        }
        idle.1.pop()
    };
    let job = match worker {
        Some(worker) => match worker.send(job) {
            Ok(()) => return,
            Err(mpsc::SendError(job)) => job,
        },
        None => job,
    };
    let (sender, receiver) = mpsc::channel::<Job>();
    let again = sender.clone();
    let body = move || {
        for job in receiver {
            job();
            let mut idle = IDLE.lock().unwrap_or_else(PoisonError::into_inner);
            if idle.0 == std::process::id() {
                idle.1.push(again.clone());
            }
        }
    };
    // Where no thread can be had the job is dropped, and who waits is told.
    if thread::Builder::new().name("extrados".to_owned()).stack_size(STACK).spawn(body).is_ok() {
        let _ = sender.send(job);
    }
}

/// Whose the threads of analyses are.
static OWNER: AtomicU32 = AtomicU32::new(0);
static START: Once = Once::new();
/// Threads of a process that was forked after its parent had computed.
static FORKED: Mutex<Option<(u32, Arc<rayon::ThreadPool>)>> = Mutex::new(None);

fn builder() -> rayon::ThreadPoolBuilder {
    let asked = std::env::var("EXTRADOS_THREADS").ok().and_then(|words| words.trim().parse().ok());
    rayon::ThreadPoolBuilder::new().num_threads(asked.unwrap_or(0)).stack_size(STACK)
}

fn in_pool<T: Send>(work: impl FnOnce() -> T + Send) -> T {
    START.call_once(|| {
        OWNER.store(std::process::id(), Ordering::Relaxed);
        // Only fails where a pool is there already.
        let _ = builder().build_global();
    });
    let own = std::process::id();
    if OWNER.load(Ordering::Relaxed) == own {
        return work();
    }
    let pool = {
        let mut forked = FORKED.lock().unwrap_or_else(PoisonError::into_inner);
        match &*forked {
            Some((process, pool)) if *process == own => Arc::clone(pool),
            _ => {
                let pool = Arc::new(builder().build().expect("threads for the analyses of a forked process"));
                *forked = Some((own, Arc::clone(&pool)));
                pool
            }
        }
    };
    pool.install(work)
}

/// How many threads analyses use.
pub(crate) fn threads() -> usize {
    in_pool(rayon::current_num_threads)
}

// ---- panics

static LAST: Mutex<String> = Mutex::new(String::new());

/// Panics are kept for the exception that names them, and print nothing.
pub(crate) fn keep_panics() {
    std::panic::set_hook(Box::new(|panic| {
        let place = panic.location().map_or(String::new(), |at| format!(" at {}:{}", at.file(), at.line()));
        *LAST.lock().unwrap_or_else(PoisonError::into_inner) = place;
    }));
}

fn panicked(panic: &(dyn Any + Send)) -> String {
    let words = panic.downcast_ref::<&str>().map(|words| (*words).to_owned());
    let words = words.or_else(|| panic.downcast_ref::<String>().cloned()).unwrap_or_else(|| "a panic".to_owned());
    format!("{words}{}", LAST.lock().unwrap_or_else(PoisonError::into_inner))
}
