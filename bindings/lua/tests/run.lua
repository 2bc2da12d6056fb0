-- SPDX-License-Identifier: MIT
-- Runs the tests of the binding: luajit tests/run.lua. SHD_LIBRARY is the path of libshd.
local here = arg[0]:match("^(.*)/") or "."
package.path = here .. "/?.lua;" .. here .. "/../?.lua;" .. package.path
local support = require "support"
for _, name in ipairs {"api", "lookup", "objects", "callbacks", "tiles", "components", "misuse"} do dofile(here .. "/test_" .. name .. ".lua") end
print(("%d cases, %d failed"):format(support.count, support.failures))
os.exit(support.failures == 0 and 0 or 1, true)
