// SPDX-License-Identifier: MIT
/// @file
/// Stage contract: film, (radiance -> linear image).
///
/// Input:      premultiplied scene-linear colour, depth and auxiliary values of shaded fragments.
/// Output:     planes of one size, row 0 on top, resolved from the samples; copies of them in the caller's columns and
///             images.
/// Units:      colour scene-linear, premultiplied by alpha; depth 0 near .. 1 far.
/// Invariants: reading changes nothing; integer formats clamp to 0..1, NaN to 0, and round to nearest; float
///             formats keep NaN and infinities.
///
/// | file             | what                                                        |
/// |------------------|-------------------------------------------------------------|
/// | framebuffer.h    | Framebuffer: its planes, and which of them there are        |
/// | planes.h         | what each plane holds and where it comes from               |
/// | readback.h       | planes to columns, colour to interleaved images             |
/// | frame.h          | a whole frame: every stage of each pass, tile by tile       |
/// | frame_memory.h   | the memory that a frame works in, counted                   |
/// | stopwatch.h      | the time its stages take                                    |
/// | shadow_map.h     | the depths that a light sees, drawn as frames               |
/// | supersample.h    | the same of a picture n times as large, averaged            |
/// | stats.h          | its statistics, added up                                    |
/// | passes.h         | its draws in passes that fit in memory                      |
/// | sample_store.h   | what samples hold from one pass to the next                 |
/// | scene.h          | a frame after its geometry stages                           |
/// | visibility.h     | the order of painting, where depth does not decide          |
/// | tile_renderer.h  | one tile: what is visible, then what blends, in order       |
/// | tile_state.h     | that tile while it is drawn                                 |
/// | tile_area.h      | its place in the framebuffer                                |
/// | tile_color.h     | the colours of its samples                                  |
/// | worker.h         | the memory that one worker needs for it                     |
/// | fragment_batch.h | fragments gathered into the table that is shaded            |
/// | opaque_pass.h    | draws of which the visibility buffer tells what they show   |
/// | blended_pass.h   | draws that are blended, or drop fragments, in order         |
/// | unordered_pass.h | draws whose blend has no order                              |
/// | aovs.h           | auxiliary planes of shaded fragments                        |
/// | blend.h          | one colour over another                                     |
/// | unordered.h      | blends that do not go by the order of draws                 |
#pragma once
