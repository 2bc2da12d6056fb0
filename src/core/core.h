// SPDX-License-Identifier: MIT
/// @file
/// Stage contract: core, the base of all other folders.
///
/// Input:      the host's callbacks (allocator, executor, log).
/// Output:     a Context with checked memory, tasks, handles and errors for every other folder.
/// Invariants: no global state except the error text and the calls of a thread, and locks for fork(); no static
///             constructors; every byte is allocated by the context's allocator; exceptions end in guard.h.
///
/// | file            | contents                                                          |
/// |-----------------|-------------------------------------------------------------------|
/// | failure.h       | Failure, a result as an exception, and refuse(), which throws it  |
/// | status.h        | fail(), which returns a result, and the per-thread error text     |
/// | guard.h         | exceptions to results                                             |
/// | errno_scope.h   | the host's errno, restored at the end of a scope                  |
/// | fp_env.h        | IEEE default floating-point control for a scope                   |
/// | call.h          | calls and callbacks of a thread; references that are dropped late |
/// | fork.h          | locks and state that a child of fork() finds usable               |
/// | printable.h     | bytes as one line of UTF-8                                        |
/// | enum_names.h    | the table of the names of enums                                   |
/// | sized_structs.h | the table of the structs that carry their size                    |
/// | regular_file.h  | opening of regular files                                          |
/// | number.h        | texts to numbers                                                  |
/// | desc_size.h     | smallest sizes of the structs that carry their size               |
/// | read_desc.h     | sized structs of the caller, in and out                           |
/// | allocator.h     | the host's allocator; Array, Objects and Buffer, which own memory |
/// | scratch.h       | working memory that is kept from call to call                     |
/// | cache_pool.h    | copies of data of objects that are kept from call to call         |
/// | simd_name.h     | names of SIMD targets                                             |
/// | simd_target.h   | the SIMD target of a context and the dispatch to it               |
/// | simd_narrow.h   | the SIMD target of a few elements                                 |
/// | context.h       | Context: allocator, executor, log, target, handles, scratch       |
/// | executor.h      | parallel_for over a Context                                       |
/// | object.h        | handles: slabs, reference counts, type and life tags              |
///
/// The headers up to read_desc.h, except status.h and call.h, need no library: libshd_color, libshd_io and its worker
/// process include them as well. simd_name.h needs Highway's headers only: libshd_color includes it.
#pragma once
