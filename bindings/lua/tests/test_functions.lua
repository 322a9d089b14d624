-- Every function of the library is called, with success; getters tell what setters were given.
local contdyn = require("contdyn")

-- A new object; as what has a length and a collider, or a hull, which some functions need.
local function make(kind, long)
  local made = contdyn[kind.class](unpack(kind.sizes))
  if long and made.set_rest_length then
    if kind.class == "Membrane" then made:set_rest_length(1, 1) else made:set_rest_length(1) end
    made:set_colliders(1)
    made:set_loads(true)
  end
  if long and made.set_hulls then made:set_hulls(1, 1, 1); made:set_disc(0, 1, 1) end
  return made
end

for _, kind in ipairs(require("every_function")) do
  local called = {}
  for _, entry in ipairs(kind.calls) do
    called[entry.name] = true
    test(entry.name, function()
      local other = make(kind)
      local saved = other:save()
      local object = make(kind)
      local ok, raised = pcall(entry.call, object, other, saved)
      if not ok and (raised.status == "error_unsupported" or raised.status == "error_range") then
        object = make(kind, true)
        ok, raised = pcall(entry.call, object, other, saved)
      end
      if not ok and not (entry.may_fail and (raised.status == "error_unsupported" or raised.status == "error_null")) then error(raised, 0) end
      if ok and entry.told then
        local told, wanted = entry.told(object)
        equal(#told, #wanted)
        for k = 1, #wanted do equal(told[k], wanted[k], entry.name) end
      end
      object:destroy()
      refused("error_null", ("cd_%s_"):format(kind.class:lower()), entry.call, object, other, saved)
    end)
  end
  test(kind.class .. ": every method is called", function()
    for name, method in pairs(contdyn[kind.class]) do
      local c_name = "cd_" .. kind.class:lower() .. "_" .. name
      local own = ({create = true, destroy = true, read = true, write = true, get_size = true})[name]
      if type(method) == "function" and name:sub(1, 1) ~= "_" and not own then assert(called[c_name], c_name) end
    end
  end)
end

test("enumerators have C's values", function()
  local file = assert(io.open(BINDINGS .. "api.json"))
  local text = file:read("*a")
  file:close()
  text = text:sub((text:find('"enums"', 1, true)), (text:find('"callbacks"', 1, true)))
  local enum, checked = nil, 0
  for name, at in text:gmatch('"name": "([%w_]+)"()') do
    if name:find("^cd_") then
      enum = contdyn[name:sub(4)]
    else
      local short, value = text:match('^,%s+"short": "([%w_]+)",%s+"value": (%d+)', at)
      equal(enum[short], tonumber(value), name)
      checked = checked + 1
    end
  end
  assert(checked > 60)
end)

test("functions of no object", function()
  equal(contdyn.status_name("error_value"), "CD_ERROR_VALUE")
  equal(contdyn.status_name(1000), "CD_ERROR_UNKNOWN")
  equal(contdyn.kernels_name("avx512"), "AVX-512")
  equal(bit.band(contdyn.runnable_kernels(), 1), 1)
  local kind, first, second, components, precision = contdyn.saved_shape(contdyn.Membrane(4, 5, 2, "float64"):save())
  equal(table.concat({kind, first, second, components, precision}, " "), "membrane 4 5 2 float64")
  local version = contdyn.version()
  equal(contdyn.version_string(), ("%d.%d.%d"):format(
    math.floor(version / 1000000), math.floor(version / 1000) % 1000, version % 1000))
  assert(contdyn.build_info():find("objects: "))
  local rope = contdyn.Chain(1, 2, 2)
  pcall(rope.set_mass, rope, -1)
  assert(contdyn.error_message():find("mass is -1", 1, true))
end)
