-- Objects are collected, and can be destroyed; nothing dangles.
local contdyn = require("contdyn")
local ffi = require("ffi")

test("a destroyed object refuses calls", function()
  local rope = contdyn.Chain(1, 4, 2)
  assert(tostring(rope):find("contdyn.Chain%(1, 4, 2, float64%)"))
  local at = rope:view("position")
  rope:destroy()
  rope:destroy()
  equal(tostring(rope), "contdyn.Chain (destroyed)")
  refused("error_null", "cd_chain_step", rope.step, rope, 0.01, 1)
  refused("error_null", "cd_chain_view", at, 0, 0, 0)
  refused("error_null", "cd_chain_copy_state", contdyn.Chain(1, 4, 2).copy_state, contdyn.Chain(1, 4, 2), rope)
end)

test("a view of a field that was switched off says so", function()
  local rope = contdyn.Chain(1, 4, 2)
  rope:enable_field("force")
  local force = rope:view("force")
  equal(force(0, 0, 0), 0)
  rope:disable_field("force")
  refused("error_disabled", "cd_chain_view", force, 0, 0, 0)
  rope:enable_field("force")
  equal(force(0, 4, 1), 0)
end)

test("a view keeps its object", function()
  local at = contdyn.Chain(1, 4, 2):view("position")
  for _ = 1, 3 do collectgarbage() end
  equal(at(0, 4, 1), 0)
end)

test("other objects are refused", function()
  local rope, sheet = contdyn.Chain(1, 4, 2), contdyn.Membrane(2, 2, 2)
  assert(not pcall(rope.step, sheet, 0.01, 1))
  assert(not pcall(rope.copy_state, rope, sheet))
end)

test("errors", function()
  local ok, raised = pcall(contdyn.Chain, 1, 10, 5)
  assert(not ok and getmetatable(raised) == contdyn.Error)
  equal(raised.status, "error_value")
  equal(raised.code, contdyn.status.error_value)
  equal(tostring(raised), raised.message)
  assert(raised.message:find("cd_chain_create: components is 5", 1, true), raised.message)
end)

test("failed calls change nothing, diverged ones can be reset", function()
  local rope = contdyn.Chain(1, 4, 1)
  local before = rope:hash()
  refused("error_value", "mass is -1", rope.set_mass, rope, -1)
  equal(rope:hash(), before)
  rope:set_method("forward_euler")
  rope:set_stiffness(1e50)
  rope:write_f64("position", 0, 1, 2, 1, {1e300})
  refused("error_diverged", "cd_chain_step", rope.step, rope, 1, 1000)
  rope:reset()
end)

test("collected objects give their memory back", function()
  local live = 0
  local C = ffi.C
  ffi.cdef "int posix_memalign(void** out, size_t alignment, size_t size); void free(void* pointer);"
  local allocator = contdyn.allocator {
    allocate = function(bytes, alignment)
      local out = ffi.new("void*[1]")
      if C.posix_memalign(out, math.max(alignment, 8), bytes) ~= 0 then return nil end
      live = live + 1
      return out[0]
    end,
    release = function(pointer)
      live = live - 1
      C.free(pointer)
    end,
  }
  local kept = contdyn.Chain(1, 10, 3, "float32", allocator)
  local alone = live
  assert(alone > 0)
  for _ = 1, 10 do contdyn.Chain(1, 10, 3, "float32", allocator) end
  assert(live > alone)
  for _ = 1, 3 do collectgarbage() end
  equal(live, alone)
  kept:destroy()
  equal(live, 0)
  refused("error_memory", "cd_water_create", contdyn.Water, 4, 4, 1, 1, "float64",
    contdyn.allocator {allocate = function() return nil end, release = function() end})
end)
