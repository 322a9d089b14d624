-- Lua functions that the library calls.
local contdyn = require("contdyn")

local function large()
  local made = contdyn.Chain(100, 20, 3)
  made:set_gravity({0, -1, 0})
  made:set_end("first", "pinned")
  return made
end

test("work is spread, and the bits are the same", function()
  local alone, spread, pieces = large(), large(), 0
  local function steps()
    for _ = 1, 200 do -- enough for the loop to be compiled
      alone:step(0.01)
      spread:step(0.01)
    end
  end
  steps() -- the library must not be called by what is compiled here once it calls back
  spread:set_parallel(contdyn.parallel {
    run = function(count, task)
      for index = count - 1, 0, -1 do
        task(index)
        pieces = pieces + 1
      end
    end,
  })
  steps()
  assert(pieces > 200)
  equal(alone:hash(), spread:hash())
  local before = pieces
  spread:set_parallel(nil)
  spread:step(0.01, 1)
  equal(pieces, before)
end)

test("an error in a callback comes out of the call", function()
  local made = large()
  made:set_parallel(contdyn.parallel {
    run = function(count, task)
      for index = 0, count - 1 do task(index) end
      error("thrown on the way", 0)
    end,
  })
  local ok, raised = pcall(made.step, made, 0.01, 1)
  assert(not ok)
  equal(raised, "thrown on the way")
  made:set_parallel(nil)
  made:step(0.01, 1)
end)
