// SPDX-License-Identifier: MIT
// Tests of the module in Node: node run.mjs [threads]
import { test } from "./support.mjs";
import "./test_garbage.mjs";
import "./test_lookup.mjs";
import "./test_objects.mjs";
import "./test_pool.mjs";
import "./test_random.mjs";
import "./test_render.mjs";
import "./test_scene.mjs";
import "./test_threads.mjs";
import "./test_tiles.mjs";

await test.run();
