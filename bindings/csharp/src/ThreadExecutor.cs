// SPDX-License-Identifier: MIT
using System;
using System.Collections.Generic;
using System.Threading;

namespace Shd
{
    /// <summary>
    /// Runs tasks on background threads of the runtime, which all executors share. It is the default with Mono: Mono
    /// waits at the end of the process for native threads that ran a callback, and those of the library never end.
    /// </summary>
    public sealed class ThreadExecutor : Executor
    {
        private readonly int workers;

        /// <summary>`workers` counts the thread that calls the library; 0 = one per core.</summary>
        public ThreadExecutor(int workers = 0)
        {
            if (workers < 0 || workers > 1024)
                throw new ArgumentOutOfRangeException("workers", workers + " is not in [0, 1024]");
            this.workers = workers > 0 ? workers : Math.Min(1024, System.Environment.ProcessorCount);
        }

        internal static bool IsMono { get { return Type.GetType("Mono.Runtime") != null; } }

        public override int WorkerCount { get { return workers; } }

        public override void ParallelFor(long count, ParallelTask task)
        {
            Job job = new Job(count, task);
            Pool.Offer(job, (int)Math.Min(workers, count) - 1);
            job.Run(0);
            job.Wait();
        }

        /// <summary>The tasks of one call. Threads that come late find none left.</summary>
        private sealed class Job
        {
            private readonly long count;
            private readonly ParallelTask task;
            private readonly object guard = new object();
            private long next;
            private int lastWorker, running;

            internal Job(long count, ParallelTask task)
            {
                this.count = count;
                this.task = task;
            }

            /// <summary>Runs tasks as another worker, unless none are left.</summary>
            internal void Help()
            {
                int worker;
                lock (guard)
                {
                    if (Interlocked.Read(ref next) >= count) return;
                    worker = ++lastWorker;
                    ++running;
                }
                Run(worker);
                lock (guard)
                    if (--running == 0) Monitor.PulseAll(guard);
            }

            internal void Run(int worker)
            {
                for (long i; (i = Interlocked.Increment(ref next) - 1) < count;) task.Run(i, worker);
            }

            /// <summary>Waits for the threads that help. Run(0) has returned, so no other thread begins.</summary>
            internal void Wait()
            {
                lock (guard)
                    while (running > 0) Monitor.Wait(guard);
            }
        }

        /// <summary>Threads that wait for jobs.</summary>
        private static class Pool
        {
            private static readonly Queue<Job> Jobs = new Queue<Job>();
            private static int threads, idle;

            /// <summary>Asks `helpers` threads to help; starts threads if too few are idle.</summary>
            internal static void Offer(Job job, int helpers)
            {
                if (helpers <= 0) return;
                lock (Jobs)
                {
                    for (int i = 0; i < helpers; ++i) Jobs.Enqueue(job);
                    for (; threads < 1023 && idle < Jobs.Count && threads < helpers; ++threads, ++idle)
                        new Thread(Serve) { IsBackground = true, Name = "shd" }.Start();
                    if (helpers == 1) Monitor.Pulse(Jobs);
                    else Monitor.PulseAll(Jobs);
                }
            }

            private static void Serve()
            {
                while (true)
                {
                    Job job;
                    lock (Jobs)
                    {
                        while (Jobs.Count == 0) Monitor.Wait(Jobs);
                        --idle;
                        job = Jobs.Dequeue();
                    }
                    job.Help();
                    lock (Jobs) ++idle;
                }
            }
        }
    }
}
