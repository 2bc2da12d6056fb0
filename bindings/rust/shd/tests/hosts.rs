// SPDX-License-Identifier: MIT
//! Executors and logs of the host.
mod common;

use std::panic::AssertUnwindSafe;
use std::sync::{Arc, Mutex};

use common::{draw, message, panic_text, program};
use shd::*;

/// Runs tasks by a function.
struct Host<F>(F);

impl<F: Fn(&Tasks<'_>) + Send + Sync> Executor for Host<F> {
    fn worker_count(&self) -> usize {
        3
    }
    fn parallel_for(&self, tasks: &Tasks<'_>) {
        (self.0)(tasks)
    }
}

fn context(run: impl Fn(&Tasks<'_>) + Send + Sync + 'static) -> Context {
    Context::builder(ContextDesc::default()).executor(Host(run)).build().unwrap()
}

fn threads(tasks: &Tasks<'_>) {
    std::thread::scope(|scope| {
        for worker in 0..3 {
            scope.spawn(move || tasks.work(worker));
        }
    });
}

/// A batch that is split into tasks.
fn look_up(context: &Context) -> Result<Vec<f32>> {
    let sampler = Sampler::new(context, &SamplerDesc::default())?;
    let u: Vec<f32> = (0..100_000).map(|i| i as f32 / 4096.0).collect();
    let mut red = vec![0.0; u.len()];
    let mut texels = Texels::new().channel(0, &mut red);
    common::checker(context).sample(&sampler, &Lookups::new(&u, &u), &mut texels)?;
    Ok(red)
}

#[test]
fn an_executor_gives_the_same_bits() {
    let (own, built_in) = (context(threads), Context::new().unwrap());
    assert_eq!(own.worker_count(), 3);
    assert_eq!(look_up(&own).unwrap(), look_up(&built_in).unwrap());
    let by_uv = |context: &Context| {
        let material = program(context, |fragments, out| out.r.copy_from_slice(fragments.u));
        draw(context, &material).unwrap()
    };
    assert_eq!(by_uv(&own), by_uv(&built_in));
}

#[test]
fn an_executor_must_run_every_task_once() {
    let lazy = context(|tasks| tasks.run(0, 0));
    let error = look_up(&lazy).unwrap_err();
    assert_eq!(error.code(), ResultCode::ERROR_CALLBACK);
    assert!(error.message().contains("ran 1 of"), "{error}");
    let eager = context(|tasks| (0..tasks.count()).for_each(|_| tasks.run(0, 0)));
    assert!(message(look_up(&eager)).contains("ran a task twice"));
    let beyond = context(|tasks| tasks.run(tasks.count(), 0));
    assert!(message(look_up(&beyond)).contains("index or worker out of range"));
}

#[test]
fn a_panic_of_an_executor_continues() {
    let broken = context(|_| panic!("no threads left"));
    assert_eq!(panic_text(AssertUnwindSafe(|| drop(look_up(&broken)))), "no threads left");
    let wrong = context(|tasks| tasks.run(0, 3));
    assert_eq!(panic_text(AssertUnwindSafe(|| drop(look_up(&wrong)))), "tasks.run: worker 3 is not in 0..3");
}

#[test]
fn a_worker_runs_one_task() {
    // Two threads share worker 0. The second one panics as soon as it overlaps the first, which the scope passes on.
    let shared = context(|tasks| {
        std::thread::scope(|scope| {
            for _ in 0..2 {
                scope.spawn(move || tasks.work(0));
            }
        });
    });
    let overlaps = (0..200).any(|_| std::panic::catch_unwind(AssertUnwindSafe(|| look_up(&shared))).is_err());
    assert!(overlaps, "200 batches never overlapped");
}

#[test]
fn callbacks_live_as_long_as_the_last_object() {
    let alive = Arc::new(());
    let inside = alive.clone();
    let own = context(move |tasks| {
        let _kept = &inside;
        threads(tasks);
    });
    let texture = common::checker(&own);
    drop(own);
    assert_eq!(Arc::strong_count(&alive), 2);
    let other = Context::new().unwrap();
    let slot = Slot::texture(SlotTarget::DIFFUSE, &texture, None);
    let material = Material::builder(MaterialDesc::default()).slot(slot).build(&other).unwrap();
    drop((texture, other));
    assert_eq!(Arc::strong_count(&alive), 2);
    drop(material);
    assert_eq!(Arc::strong_count(&alive), 1);
}

#[cfg(unix)]
#[test]
fn a_panic_of_a_log_ends_the_process() {
    const VARIABLE: &str = "SHD_TEST_LOG_PANIC";
    if std::env::var_os(VARIABLE).is_some() {
        let context = Context::builder(ContextDesc::default()).log(|_, _| panic!("full")).build().unwrap();
        let _ = std::panic::catch_unwind(AssertUnwindSafe(|| context.log(LogLevel::INFO, "line")));
        return;
    }
    let mut child = std::process::Command::new(std::env::current_exe().unwrap());
    child.env(VARIABLE, "1").args(["--exact", "a_panic_of_a_log_ends_the_process"]);
    let output = child.output().unwrap();
    // The process ended by a signal, and not by its own exit.
    assert_eq!(output.status.code(), None, "{output:?}");
}

#[test]
fn lines_of_the_log_arrive() {
    let lines = Arc::new(Mutex::new(Vec::new()));
    let inside = lines.clone();
    let write = move |level, line: &str| inside.lock().unwrap().push((level, line.to_string()));
    let context = Context::builder(ContextDesc::default()).log(write).build().unwrap();
    context.log(LogLevel::WARNING, "tiles are missing");
    drop(context);
    assert_eq!(Arc::strong_count(&lines), 1);
    assert_eq!(*lines.lock().unwrap(), [(LogLevel::WARNING, "tiles are missing".to_string())]);
}
