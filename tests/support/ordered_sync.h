// SPDX-License-Identifier: MIT
// Threads in every order. An Explorer runs one of a few threads and chooses, at each lock, wait, and access of an
// atomic, which of them goes on. It repeats the run until it has made every choice with at most `preemptions` changes
// from a thread that could go on (Musuvathi and Qadeer, "Iterative Context Bounding for Systematic Testing of
// Multithreaded Programs" (2007)). Atomics are sequentially consistent. Time stands still: waits have no end.
//
// It replaces src/texture/store/tiles/sync.h, in the namespace of the code under test.
#pragma once

#include <semaphore.h>

#include <atomic>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <string>
#include <thread>
#include <vector>

namespace shd::orders
{

class Explorer
{
   public:
    static constexpr int kMost = 4;

    /// The explorer of the test; threads that it does not run pass all points.
    static Explorer *&current()
    {
        static Explorer *explorer = nullptr;
        return explorer;
    }
    static int &self()
    {
        static thread_local int number = -1;
        return number;
    }

    /// @param atomics  accesses of atomics are points as well
    Explorer(int threads, int preemptions, bool atomics) : count_(threads), bound_(preemptions), atomics_(atomics)
    {
        for (int i = 0; i < count_; ++i) sem_init(&thread_[i].turn, 0, 0);
        sem_init(&done_, 0, 0);
        current() = this;
        for (int i = 0; i < count_; ++i) {
            thread_[i].thread = std::thread([this, i] { serve(i); });
        }
    }
    ~Explorer()
    {
        stop_ = true;
        for (int i = 0; i < count_; ++i) sem_post(&thread_[i].turn);
        for (int i = 0; i < count_; ++i) thread_[i].thread.join();
        current() = nullptr;
    }

    /// Runs bodies once, in the next order. Returns false when there are no more orders.
    bool run(std::vector<std::function<void()>> bodies)
    {
        bodies_ = std::move(bodies);
        depth_ = 0;
        used_ = 0;
        steps_ = 0;
        for (int i = 0; i < count_; ++i) thread_[i].state = kReady;
        running_ = -1;
        choose();
        sem_wait(&done_);
        ++runs;
        while (!choices_.empty() && choices_.back().taken + 1 == choices_.back().options) choices_.pop_back();
        if (choices_.empty()) return false;
        ++choices_.back().taken;
        return true;
    }

    /// A thread is about to do what others can see.
    void point(bool atomic = false)
    {
        if (self() < 0 || (atomic && !atomics_)) return;
        choose();
    }
    /// The thread waits until something happens to `what`.
    void block(const void *what)
    {
        thread_[self()].state = kBlocked;
        thread_[self()].what = what;
        choose();
    }
    void wake(const void *what)
    {
        for (int i = 0; i < count_; ++i) {
            if (thread_[i].state == kBlocked && thread_[i].what == what) thread_[i].state = kReady;
        }
    }
    /// Another thread has to go on first.
    void yield()
    {
        if (self() < 0) return;
        thread_[self()].state = kYielded;
        choose();
    }

    [[noreturn]] void report(const char *what)
    {
        std::fprintf(stderr, "order %llu: %s; choices:", static_cast<unsigned long long>(runs), what);
        for (const Choice &choice : choices_) std::fprintf(stderr, " %d", choice.taken);
        std::fprintf(stderr, "\n");
        for (int i = 0; i < count_; ++i) {
            std::fprintf(stderr, "  thread %d: %s\n", i,
                         thread_[i].state == kBlocked ? "waits" : "goes on or has ended");
        }
        std::fflush(stderr);
        std::_Exit(1);
    }

    uint64_t runs = 0, points = 0;

   private:
    enum State { kReady, kYielded, kBlocked, kEnded };
    struct Thread {
        std::thread thread;
        sem_t turn;
        State state = kEnded;
        const void *what = nullptr;
    };
    struct Choice {
        int taken, options;
    };

    void serve(int number)
    {
        self() = number;
        for (;;) {
            wait_turn(number);
            if (stop_) return;
            bodies_[static_cast<size_t>(number)]();
            thread_[number].state = kEnded;
            choose();
        }
    }
    void wait_turn(int number)
    {
        while (sem_wait(&thread_[number].turn) != 0) {
        }
    }

    /// Chooses who goes on, lets it, and returns when it is this thread's turn again.
    void choose()
    {
        ++points;
        const int me = self();
        const bool can_go_on = me >= 0 && running_ == me && thread_[me].state == kReady;
        int options[kMost], count = 0;
        if (can_go_on) options[count++] = me;
        if (!can_go_on || used_ < bound_) {
            for (int i = 0; i < count_; ++i) {
                if (i != me && (thread_[i].state == kReady || thread_[i].state == kYielded)) options[count++] = i;
            }
        }
        if (count == 0 && me >= 0 && thread_[me].state == kYielded) options[count++] = me;
        if (count == 0) return end_run();
        if (++steps_ > 100000) report("no end");
        int taken = 0;
        if (count > 1) {
            if (depth_ == choices_.size()) choices_.push_back({0, count});
            taken = choices_[depth_++].taken;
        }
        const int next = options[taken];
        used_ += can_go_on && next != me;
        if (me >= 0 && thread_[me].state == kYielded) thread_[me].state = kReady;
        running_ = next;
        thread_[next].state = kReady;
        if (next == me) return;
        const bool ended = me >= 0 && thread_[me].state == kEnded;
        sem_post(&thread_[next].turn);
        if (me >= 0 && !ended) wait_turn(me);
    }

    void end_run()
    {
        for (int i = 0; i < count_; ++i) {
            if (thread_[i].state != kEnded) report("dead-lock");
        }
        sem_post(&done_);
    }

    const int count_, bound_;
    const bool atomics_;
    Thread thread_[kMost];
    std::vector<std::function<void()>> bodies_;
    std::vector<Choice> choices_;
    size_t depth_ = 0;
    int used_ = 0, running_ = -1, steps_ = 0;
    sem_t done_;
    bool stop_ = false;
};

inline void point(bool atomic = false)
{
    if (Explorer *explorer = Explorer::current()) explorer->point(atomic);
}

}  // namespace shd::orders

namespace shd::texture
{

class TileMutex
{
   public:
    void attach() {}
    void lock()
    {
        orders::point();
        while (held_) orders::Explorer::current()->block(this);
        held_ = true;
    }
    void unlock()
    {
        held_ = false;
        if (orders::Explorer *explorer = orders::Explorer::current()) explorer->wake(this);
    }

   private:
    bool held_ = false;
};

class TileCondition
{
   public:
    void notify_all()
    {
        if (orders::Explorer *explorer = orders::Explorer::current()) explorer->wake(this);
    }
    void wait(TileMutex &mutex)
    {
        mutex.unlock();
        orders::Explorer::current()->block(this);
        mutex.lock();
    }
    template <class Time>
    bool wait_until(TileMutex &mutex, const Time &)
    {
        wait(mutex);
        return true;
    }
    void renew() {}
};

template <class T>
class TileAtomic
{
   public:
    TileAtomic() = default;
    TileAtomic(T value) : value_(value) {}  // NOLINT: as std::atomic
    T load(std::memory_order = std::memory_order_seq_cst) const
    {
        orders::point(true);
        return value_;
    }
    void store(T value, std::memory_order = std::memory_order_seq_cst)
    {
        orders::point(true);
        value_ = value;
    }
    T exchange(T value, std::memory_order = std::memory_order_seq_cst)
    {
        orders::point(true);
        const T before = value_;
        value_ = value;
        return before;
    }
    T fetch_add(T value, std::memory_order = std::memory_order_seq_cst)
    {
        orders::point(true);
        const T before = value_;
        value_ = static_cast<T>(value_ + value);
        return before;
    }
    T fetch_sub(T value, std::memory_order = std::memory_order_seq_cst)
    {
        orders::point(true);
        const T before = value_;
        value_ = static_cast<T>(value_ - value);
        return before;
    }

   private:
    T value_{};
};

inline void yield_tile_thread()
{
    if (orders::Explorer *explorer = orders::Explorer::current()) explorer->yield();
}

}  // namespace shd::texture
