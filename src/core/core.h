// SPDX-License-Identifier: MIT
/// @file
/// Stage contract: core, the ground everything stands on.
///
/// Input:      the host's callbacks (allocator, executor, log).
/// Output:     a Context with checked memory, tasks, handles and errors for every other folder.
/// Invariants: no global state but the per-thread error text; no static constructors; every byte comes from
///             the context's allocator; exceptions end in abi/guard.h.
///
/// | file          | what                                                             |
/// |---------------|------------------------------------------------------------------|
/// | status.h      | results, the per-thread error text, Failure (a result as exception) |
/// | allocator.h   | the host's allocator; Array, Objects and Buffer, which own memory  |
/// | fp_env.h      | IEEE default floating-point control for a scope                    |
/// | simd_target.h | the SIMD target of a context and the dispatch to it                |
/// | context.h     | Context: allocator, executor, log, target, handle slabs            |
/// | executor.h    | parallel_for over a Context                                        |
/// | object.h      | handles: slabs, reference counts, type and life tags               |
/// | extension_error.h | refusals inside libshd_color and libshd_io, which stand outside libshd |
#pragma once
