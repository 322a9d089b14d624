-- Arrays in and out: tables, nested tables, FFI arrays; lengths that do not fit; views.
local contdyn = require("contdyn")
local ffi = require("ffi")

local function rope()
  local made = contdyn.Chain(2, 3, 2)
  local positions = {}
  for k = 1, 16 do positions[k] = k / 8 end
  made:write("position", positions)
  return made, positions
end

test("tables, nested tables and FFI arrays are written alike", function()
  local made, flat = rope()
  local wanted = made:hash()
  local nested = {{}, {}}
  for strand = 0, 1 do
    for node = 0, 3 do
      local at = strand * 8 + node * 2
      nested[strand + 1][node + 1] = {flat[at + 1], flat[at + 2]}
    end
  end
  local doubles, floats = ffi.new("double[16]", flat), ffi.new("float[16]", flat)
  for _, values in ipairs {nested, doubles, ffi.new("double[?]", 16, flat), floats} do
    local other = contdyn.Chain(2, 3, 2)
    other:write("position", values)
    equal(other:hash(), wanted)
  end
end)

test("what is a part of a field is not taken for all of it", function()
  local made = rope()
  local before = made:hash()
  refused("error_range", "write: takes whole fields only: for a part of one see write_f64",
    function() made:write("position", 1, 0, 1, 3, 1) end)
  refused("error_range", "read: takes whole fields only: for a part of one see read_f64",
    function() made:read("position", nil, 0, 1, 3, 1) end)
  equal(made:hash(), before)
end)

test("a number tells the length that no argument tells", function()
  local pool = contdyn.Water(4, 4, 1, 1)
  pool:set_hulls(1, 2, 2)
  pool:set_hull(0, 100, 2, 1)
  pool:set_hull_pose(0, {1, 2, 3, 0, 1, 0, 0})
  equal(table.concat(pool:get_hull_pose(0, 7), " "), table.concat({1, 2, 3, 0, 1, 0, 0}, " "))
  refused("error_range", "cd_water_get_hull_pose: count is 6", function() pool:get_hull_pose(0, 6) end)
  refused("error_range", "out_pose is 1.5, must be a whole number", function() pool:get_hull_pose(0, 1.5) end)
  refused("error_value", "or how many they are", function() pool:get_hull_pose(0) end)
end)

test("reads give tables, fill tables and FFI arrays", function()
  local made, flat = rope()
  local all = made:read("position")
  equal(#all, 16)
  for k = 1, 16 do equal(all[k], flat[k]) end
  local part = made:read_f64("position", 1, 1, 2, 2)
  equal(table.concat(part, " "), table.concat(flat, " ", 13, 16))
  local filled, doubles, floats = {}, ffi.new("double[16]"), ffi.new("float[16]")
  equal(made:read("position", filled), filled)
  equal(made:read("position", doubles), doubles)
  equal(made:read("position", floats), floats)
  for k = 1, 16 do
    equal(filled[k], flat[k])
    equal(doubles[k - 1], flat[k])
    equal(floats[k - 1], flat[k])
  end
  equal(made:get_size("velocity"), 16)
  equal(made:get_size("mass"), 4)
  equal(made:get_size("stiffness"), 3)
end)

test("sizes of whole fields are those that the library has", function()
  local kinds = {Chain = {{2, 5, 3}}, Membrane = {{4, 3, 3}}, Water = {{5, 4, 0.5, 0.25}}}
  local checked = 0
  for name, made_of in pairs(kinds) do
    for _, variant in ipairs {"plain", "ring", "long"} do
      local made = contdyn[name](unpack(made_of[1]))
      local two = name == "Membrane"
      if variant == "ring" and made.set_ring then made:set_ring(true, two and true or nil) end
      if variant == "long" and made.set_rest_length then made:set_rest_length(1, two and 1 or nil) end
      for field in pairs(made._fields) do
        local ok, raised = pcall(made.enable_field, made, field)
        if ok then
          local values = made:read(field)
          equal(#values, made:get_size(field))
          checked = checked + 1
          assert(#values > 0)
        else
          equal(raised.status, "error_unsupported", raised.message)
        end
      end
    end
  end
  assert(checked > 60)
end)

test("sizes of rings, ropes and faces", function()
  local chain, sheet, pool = contdyn.Chain(2, 5, 3), contdyn.Membrane(4, 3, 3), contdyn.Water(5, 4, 1, 1)
  local function sizes(made, fields)
    local found = {}
    for _, field in ipairs(fields) do found[#found + 1] = made:get_size(field) end
    return table.concat(found, " ")
  end
  local of_chains, of_sheets = {"position", "mass", "stiffness", "bend"}, {"position", "stiffness_u", "stiffness_v"}
  equal(sizes(chain, of_chains), "36 6 5 6")
  chain:set_ring(true)
  equal(sizes(chain, of_chains), "36 6 6 6")
  chain:set_ring(false)
  chain:set_rest_length(1)
  equal(sizes(chain, {"position", "mass", "stiffness"}), "36 12 10")
  equal(sizes(sheet, of_sheets), "60 16 15")
  sheet:set_ring(true, false)
  equal(sizes(sheet, of_sheets), "60 20 15")
  sheet:set_ring(false, true)
  equal(sizes(sheet, of_sheets), "60 16 20")
  equal(sizes(pool, {"depth", "velocity_x", "velocity_y"}), "20 24 25")
end)

test("outputs of functions", function()
  local made = rope()
  made:set_gravity({0, -9.81})
  equal(table.concat(made:get_gravity(), " "), "0 -9.81")
  local mine = ffi.new("double[2]")
  equal(made:get_gravity(mine), mine)
  equal(mine[1], -9.81)
  local kinetic, elastic, gravity = made:get_energy()
  equal(kinetic, 0)
  assert(elastic > 0 and gravity ~= 0)
  equal(#made:sample(1, {0, 0.5, 3}), 6)
  local pool = contdyn.Water(4, 4, 1, 1)
  pool:write("depth", 2)
  local surface, depth, normal, velocity = pool:sample({1, 1, 2, 2.5})
  equal(#surface + #depth + #normal + #velocity, 2 + 2 + 6 + 4)
  equal(depth[2], 2)
  equal(normal[3], 1)
  local none
  none, depth, normal, velocity = pool:sample({1, 100}, "nearest", false, nil, false, false)
  equal(none, nil)
  equal(#depth, 1)
  equal(normal, nil)
  equal(velocity, nil)
  local vertices = ffi.new("float[?]", 16 * 7)
  pool:write_vertices(vertices, 28, 0, 12, 24)
  equal(vertices[6], 2)
  local indices = ffi.new("uint32_t[?]", pool:get_index_count(false))
  pool:write_indices(false, indices, 4)
  assert(indices[0] ~= indices[1])
  local sheet = contdyn.Membrane(4, 4, 1)
  pcall(sheet.write_vertices, sheet, ffi.new("float[?]", 25 * 3), 12, 0, contdyn.SIZE_MAX)
  equal(contdyn.Chain(1, 4, 3):set_ring(1), nil)
end)

test("lengths that do not fit", function()
  local made = rope()
  refused("error_range", "cd_chain_set_gravity: count is 3", made.set_gravity, made, {1, 2, 3})
  refused("error_range", "cd_chain_write_f64", made.write, made, "position", {1, 2, 3})
  refused("error_range", "cd_chain_read_f64", made.read, made, "position", ffi.new("double[3]"))
  refused("error_range", "normal has 3 numbers, must have 2", made.set_plane, made, 0, {0, 0}, {1, 0, 0}, 0)
  local pool = contdyn.Water(4, 4, 1, 1)
  refused("error_range", "at has 3 numbers, must be a multiple of 2", pool.sample, pool, {1, 2, 3})
  refused("error_range", "out_depth has 3 numbers, must have 1", pool.sample, pool, {1, 1}, nil, nil,
    ffi.new("double[3]"))
end)

test("what is set or written by methods is not assigned", function()
  local made = rope()
  refused("error_value", "Chain.mass: it is set by set_mass", function() made.mass = 2 end)
  refused("error_value", "Chain.position: a field is written by write(\"position\", values)",
    function() made.position = {{0, 0}} end)
  refused("error_value", "Water.hulls: it is set by set_hulls", function() contdyn.Water(4, 4, 1, 1).hulls = 1 end)
  made.colour = "red" -- the caller's own
  equal(made.colour, "red")
end)

test("values of other types", function()
  local made = rope()
  refused("error_value", "mass is \"2\", must be a number", made.set_mass, made, "2")
  refused("error_value", "must be true or false", made.set_ring, made, 2)
  refused("error_range", "node is -1", made.impulse, made, 0, -1, {1, 2})
  refused("error_range", "springs is 1.1529215046068e+18, must be a whole number from 0 to 2^53", contdyn.Chain.create, 1,
    2 ^ 60, 2)
  refused("error_range", "node is 1.5", made.impulse, made, 0, 1.5, {1, 2})
  refused("error_range", "node is nan", made.impulse, made, 0, 0 / 0, {1, 2})
  refused("error_enum", "must be one of driven, free", made.set_end, made, "first", "pin")
  refused("error_enum", "cd_chain_set_end", made.set_end, made, "first", 77)
  refused("error_value", "has a string in it", made.set_gravity, made, {1, "x"})
  refused("error_value", "must be a table of numbers", made.set_gravity, made, 5)
  local floats = ffi.new("float[2]")
  refused("error_value", "must be an FFI array of double", made.read_f64, made, "position", 0, 1, 0, 1, floats)
  local pointer = ffi.cast("double*", ffi.new("double[2]")) -- tells no length
  refused("error_value", "must be a table of numbers", made.set_gravity, made, pointer)
end)

test("views follow steps and writes", function()
  for _, precision in ipairs {"float32", "float64"} do
    local made = contdyn.Chain(2, 3, 2, precision)
    made:set_gravity({0, -1})
    local at = made:view("position")
    for _ = 1, 3 do
      local copy = made:read("position")
      for strand = 0, 1 do
        for node = 0, 3 do
          for component = 0, 1 do
            equal(at(strand, node, component), copy[strand * 8 + node * 2 + component + 1])
          end
        end
      end
      made:step(0.5, 1)
    end
    assert(at(0, 0, 1) < 0)
    equal(select(3, at:shape()), 2)
    refused("error_range", "no place (2, 0, 0) in 2 x 4 x 2", at, 2, 0, 0)
    refused("error_range", "no place", at, 0, -1, 0)
    refused("error_range", "no place", at, 0, 0, 0 / 0)
  end
  local sheet = contdyn.Membrane(4, 2, 1)
  sheet:write_f64("position", 3, 1, 1, 1, {5})
  equal(sheet:view("position")(3, 1), 5)
  local pool = contdyn.Water(4, 3, 1, 1)
  pool:write_f64("depth", 3, 2, 1, 1, {7})
  equal(pool:view("depth")(3, 2), 7)
  refused("error_unsupported", "cd_water_view", pool.view, pool, "surface")
end)
