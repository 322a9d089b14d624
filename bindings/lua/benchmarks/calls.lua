-- What a method costs over the C function that it calls: both by turns, the least of many rounds, in nanoseconds.
local here = arg[0]:match("^(.*[/\\])") or "./"
package.path = here .. "../?.lua;" .. here .. "../?/init.lua;" .. package.path
local contdyn = require("contdyn")
local ffi = require("ffi")
local lib = ffi.load(contdyn.library_path)

local ROUNDS, CALLS = 100, 10000

local rope = contdyn.Chain(1, 10, 3)
local handle, number, gravity = rope._handle, ffi.new("double[1]"), ffi.new("double[3]")
local at = rope:view("position")

local function least(run)
  local best = math.huge
  for _ = 1, ROUNDS do
    local begin = os.clock()
    run()
    best = math.min(best, os.clock() - begin)
  end
  return best / CALLS * 1e9
end

local function row(name, bare, method)
  print(("| %s | %.0f | %.0f |"):format(name, least(bare), least(method)))
end

row("get_mass", function()
  for _ = 1, CALLS do lib.cd_chain_get_mass(handle, number) end
end, function()
  for _ = 1, CALLS do rope:get_mass() end
end)
row("set_gravity, of an FFI array", function()
  for _ = 1, CALLS do lib.cd_chain_set_gravity(handle, gravity, 3) end
end, function()
  for _ = 1, CALLS do rope:set_gravity(gravity) end
end)
row("step of 11 nodes, 3 components", function()
  for _ = 1, CALLS do lib.cd_chain_step(handle, 1e-3, 1) end
end, function()
  for _ = 1, CALLS do rope:step(1e-3) end
end)
local sum = 0
print(("| one number of a view | | %.0f |"):format(least(function()
  for _ = 1, CALLS do sum = sum + at(0, 5, 1) end
end)))
