-- What the functions in contdyn/api.lua are made with: the library, errors, arguments, results, objects and views.
local ffi = require("ffi")

local support = {}
local lib

-- ---- errors --------------------------------------------------------------------------------------------------------

-- What is raised: a table with `status`, as "error_value", its number `code`, and the `message`, which is also what
-- tostring gives.
local Error = {}
Error.__index = Error
Error.__tostring = function(self) return self.message end
support.Error = Error

local enumerations = {} -- by the C name: values by name, names by value
local pending -- what a callback raised, until the call that called it is back

local function fail(code, message)
  error(setmetatable({status = enumerations.cd_status.names[code] or code, code = code, message = message}, Error), 0)
end

local VALUE, ENUM, RANGE, UNSUPPORTED = 3, 4, 5, 9

local function check(status)
  if pending ~= nil then
    local raised = pending[1]
    pending = nil
    error(raised, 0)
  end
  if status ~= 0 then fail(status, ffi.string(lib.cd_error_message())) end
end
support.check = check

-- ---- the library ---------------------------------------------------------------------------------------------------

-- By the name that programs are linked to: before version 1 it has the minor version too.
local function candidates(major, minor)
  local abi = major > 0 and tostring(major) or major .. "." .. minor
  local names = {
    OSX = {"libcontdyn." .. abi .. ".dylib", "libcontdyn.dylib"},
    Windows = {"contdyn.dll", "libcontdyn.dll"},
  }
  names = names[ffi.os] or {"libcontdyn.so." .. abi, "libcontdyn.so"}
  local found = {}
  local here = debug.getinfo(1, "S").source:match("^@(.*[/\\])") or "./"
  local root = here .. "../../../"
  local header = io.open(root .. "include/contdyn/contdyn.h")
  if header then -- the package lies in the project's sources
    header:close()
    for _, name in ipairs(names) do found[#found + 1] = root .. "build/src/" .. name end
  end
  for _, name in ipairs(names) do found[#found + 1] = name end -- wherever the system's loader looks
  for _, folder in ipairs {"/usr/local/lib/", "/opt/homebrew/lib/"} do
    for _, name in ipairs(names) do found[#found + 1] = folder .. name end
  end
  return found
end

function support.load(major, minor)
  local named = os.getenv("CONTDYN_LIBRARY")
  local tried = {}
  for _, path in ipairs(named and {named} or candidates(major, minor)) do
    local loaded, result = pcall(ffi.load, path)
    if loaded then
      lib, support.path = result, path
      break
    end
    tried[#tried + 1] = tostring(result)
  end
  if not lib then
    error("contdyn's shared library was not found; tell where it is in the environment variable CONTDYN_LIBRARY, as in "
      .. "CONTDYN_LIBRARY=build/src/libcontdyn.so\n" .. table.concat(tried, "\n"), 0)
  end
  local version = lib.cd_version()
  if math.floor(version / 1000) ~= major * 1000 + minor then -- before 1.0 every minor version may change the API
    error(("%s is contdyn %s, and this package is written for %d.%d"):format(
      support.path, ffi.string(lib.cd_version_string()), major, minor), 0)
  end
  return lib
end

-- ---- arguments -----------------------------------------------------------------------------------------------------

local function shown(value)
  return type(value) == "string" and ("%q"):format(value) or tostring(value)
end

function support.enumeration(c_name, values)
  local names = {}
  for name, value in pairs(values) do names[value] = name end
  enumerations[c_name] = {values = values, names = names}
  return values
end

-- An enumerator is given by its name, or by C's number, which the library looks at.
function support.enum_in(c_name, value, where, name)
  if type(value) == "number" then return value end
  local found = enumerations[c_name].values[value == nil and 0 or value]
  if not found then
    local known = {}
    for word in pairs(enumerations[c_name].values) do known[#known + 1] = word end
    table.sort(known)
    fail(ENUM, ("%s: %s is %s, must be one of %s"):format(where, name, shown(value), table.concat(known, ", ")))
  end
  return found
end

function support.enum_out(c_name, value)
  return enumerations[c_name].names[value] or value
end

function support.flag_in(value, where, name)
  if value == true or value == 1 then return 1 end
  if value == false or value == 0 then return 0 end
  fail(VALUE, ("%s: %s is %s, must be true or false"):format(where, name, shown(value)))
end

function support.number_in(value, where, name)
  if type(value) ~= "number" then
    fail(VALUE, ("%s: %s is %s, must be a number"):format(where, name, shown(value)))
  end
  return value
end

local MOST = 2 ^ 53
local uint64, int64, size = ffi.typeof("uint64_t"), ffi.typeof("int64_t"), ffi.typeof("size_t")
support.SIZE_MAX = ffi.cast(size, -1)

function support.integer_in(value, where, name)
  if type(value) == "number" and value >= 0 and value <= MOST and value == math.floor(value) then return value end
  if ffi.istype(uint64, value) or ffi.istype(size, value) or ffi.istype(int64, value) and value >= 0 then
    return value
  end
  fail(RANGE, ("%s: %s is %s, must be a whole number from 0 to 2^53, or an FFI integer"):format(
    where, name, shown(value)))
end

local array_types, element_sizes = {}, {}
for _, base in ipairs {"double", "float", "int32_t", "uint32_t", "uint64_t", "size_t", "uint8_t"} do
  array_types[base], element_sizes[base] = ffi.typeof(base .. "[?]"), ffi.sizeof(base)
end

-- What an FFI array holds: "double" of double[3]; nil of anything else, pointers too: they do not tell their length.
local elements = {} -- by the number of the type
local function element_of(value)
  if type(value) ~= "cdata" then return nil end
  local of = ffi.typeof(value)
  local known = elements[tonumber(of)]
  if known == nil then
    known = tostring(of):match("^ctype<(.-) ?%[[%d?]+%]>$") or false
    elements[tonumber(of)] = known
  end
  return known or nil
end

local function flatten(values, into, where, name)
  for k = 1, #values do
    local value = values[k]
    if type(value) == "table" then
      flatten(value, into, where, name)
    elseif type(value) == "number" then
      into[#into + 1] = value
    else
      fail(VALUE, ("%s: %s has a %s in it, must be numbers"):format(where, name, type(value)))
    end
  end
  return into
end

-- The address of numbers and how many they are: of an FFI array of the same type where it lies, else of a copy.
function support.array_in(base, value, where, name, may_be_nil)
  if value == nil and may_be_nil then return nil, nil end
  local element = element_of(value)
  if element == base or element == "const " .. base then return value, ffi.sizeof(value) / element_sizes[base] end
  if element_sizes[element] then
    local count = ffi.sizeof(value) / element_sizes[element]
    local copy = array_types[base](count)
    for k = 0, count - 1 do copy[k] = value[k] end
    return copy, count
  end
  if type(value) ~= "table" then
    fail(VALUE, ("%s: %s is %s, must be a table of numbers or an FFI array of %s"):format(
      where, name, shown(value), base))
  end
  local flat = flatten(value, {}, where, name)
  return array_types[base](#flat, flat), #flat
end

-- Room for numbers: the caller's array, or for a table or nil a new one of `count` numbers; none for false. Where no
-- argument tells `count`, a number in the place of the array does.
function support.array_out(base, value, count, where, name)
  if value == false then return nil, nil end
  if not count and type(value) == "number" then
    count, value = tonumber(support.integer_in(value, where, name)), nil
  end
  if element_of(value) == base then return value, ffi.sizeof(value) / element_sizes[base] end
  if value ~= nil and type(value) ~= "table" or not count then
    fail(VALUE, ("%s: %s is %s, must be an FFI array of %s%s"):format(
      where, name, shown(value), base, count and ", a table to fill, or nil" or ", or how many they are"))
  end
  return array_types[base](count), tonumber(count)
end

function support.array_result(value, room, count)
  if room == nil or type(value) == "cdata" then return room end
  local result = type(value) == "table" and value or {}
  for k = 1, count do result[k] = room[k - 1] end
  return result
end

function support.bytes_in(value, where, name)
  if type(value) == "string" then return value, #value end
  if element_of(value) then return value, ffi.sizeof(value) end
  fail(VALUE, ("%s: %s is %s, must be a string or an FFI array"):format(where, name, shown(value)))
end

function support.bytes_out(value, count, where, name)
  if value == nil and count then return array_types.uint8_t(count), count end
  if element_of(value) then return value, ffi.sizeof(value) end
  fail(VALUE, ("%s: %s is %s, must be an FFI array"):format(where, name, shown(value)))
end

support.string_of = ffi.string

-- How many places `count` numbers are of, `each` of them for a place.
function support.count_of(count, each, where, name)
  local places = (count or 0) / each
  if places ~= math.floor(places) then
    fail(RANGE, ("%s: %s has %d numbers, must be a multiple of %d"):format(where, name, count, each))
  end
  return places
end

function support.same(count, wanted, where, name)
  if count ~= nil and count ~= wanted then
    fail(RANGE, ("%s: %s has %d numbers, must have %d"):format(where, name, tonumber(count), tonumber(wanted)))
  end
end

-- ---- objects -------------------------------------------------------------------------------------------------------

local classes = {}

-- The library's handle; null, which the library refuses, of an object that was destroyed.
local function handle_of(object)
  return object and object._handle
end
support.handle_of = handle_of

-- Ranges of whole fields: two extents, and how many values a place has; nil for a field that the object has not.
local function whole(object, field)
  local row = object._fields[field]
  if not row then return nil end
  local sizes, ring, rope = {object:get_shape()}, {}, false
  if object.get_ring then ring = {object:get_ring()} end
  if row[8] then rope = object:get_rest_length() > 0 end
  local function extent(at)
    return (sizes[row[at]] or 0) + row[at + 1] + (ring[row[at + 2]] and 1 or 0)
  end
  return row[8] and not rope and 1 or extent(1), extent(4), row[7] and sizes[object._components] or 1
end

function support.components_of(object)
  return (select(object._components, object:get_shape()))
end

function support.values_of(object, field)
  local row = object._fields[field]
  return row and row[7] and support.components_of(object) or 1
end

-- The range of a whole field as the four numbers that reads and writes take.
local function range(object, field)
  local a, b = whole(object, field)
  if not a then return 0, 0, 0, 0 end -- the library says what is wrong
  if object._range_alternates then return 0, a, 0, b end
  return 0, 0, a, b
end

-- Refuses the range of a part, which Lua would drop without a word.
local function only_whole(name, ...)
  if select("#", ...) == 0 then return end
  fail(RANGE, ("%s: takes whole fields only: for a part of one see %s_f64"):format(name, name))
end

local Object = {}

-- How many values a field has.
function Object:get_size(field)
  field = support.enum_in("cd_field", field, "get_size", "field")
  local a, b, values = whole(self, field)
  if not a then self:read_f64(field, 0, 0, 0, 0) end
  return a * b * values
end

-- All values of a field, as read_f64 gives them; into an FFI array of float by read_f32.
function Object:read(field, out, ...)
  only_whole("read", ...)
  field = support.enum_in("cd_field", field, "read", "field")
  local read = element_of(out) == "float" and self.read_f32 or self.read_f64
  local a, b, c, d = range(self, field)
  return read(self, field, a, b, c, d, out)
end

-- Writes all values of a field, or the one number given to all its places.
function Object:write(field, values, ...)
  only_whole("write", ...)
  field = support.enum_in("cd_field", field, "write", "field")
  if type(values) == "number" then
    local count = self:get_size(field)
    local filled = array_types.double(count)
    for k = 0, count - 1 do filled[k] = values end
    values = filled
  end
  local write = element_of(values) == "float" and self.write_f32 or self.write_f64
  local a, b, c, d = range(self, field)
  return write(self, field, a, b, c, d, values)
end

-- Releases the object; calls on it, and views of it, fail from then on. Destroying twice does nothing.
function Object:destroy()
  local handle = self._handle
  self._handle, self._version = nil, self._version + 1
  if handle ~= nil then self._destroy(ffi.gc(handle, nil)) end
end

-- The library may be built without a kind of objects, and has none of its functions then.
function support.class(name, destroy)
  local there, call = pcall(function() return lib[destroy] end)
  local class = {_name = name, _destroy = there and call or nil}
  for method, call in pairs(Object) do class[method] = call end
  class.__index = class
  -- What is a property or a field elsewhere would be kept beside the object here, and no step would know of it.
  class.__newindex = function(self, key, value)
    if class["set_" .. tostring(key)] then fail(VALUE, ("%s.%s: it is set by set_%s"):format(name, key, key)) end
    if type(key) == "string" and class._fields[enumerations.cd_field.values[key]] then
      fail(VALUE, ("%s.%s: a field is written by write(\"%s\", values)"):format(name, key, key))
    end
    rawset(self, key, value)
  end
  class.__tostring = function(self)
    if self._handle == nil then return "contdyn." .. name .. " (destroyed)" end
    local shape = {self:get_shape()}
    for k, value in ipairs(shape) do shape[k] = tostring(value) end
    return ("contdyn.%s(%s)"):format(name, table.concat(shape, ", "))
  end
  classes[#classes + 1] = class
  return setmetatable(class, {__call = function(self, ...) return self.create(...) end})
end

function support.check_built(class, where)
  if not class._destroy then fail(UNSUPPORTED, where .. ": this build of the library leaves it out") end
end

function support.own(class, handle, kept)
  return setmetatable({_handle = ffi.gc(handle, class._destroy), _version = 0, _kept = kept}, class)
end

-- ---- views ---------------------------------------------------------------------------------------------------------

local View = {}
View.__index = View

local bytes = ffi.typeof("const uint8_t*")
local pointers = {float32 = ffi.typeof("const float*"), float64 = ffi.typeof("const double*")}

-- Asks the library anew where the field lies, after every call that may have changed it.
local function refresh(view)
  local object = view._object
  local data, strides = view._ask(object._handle, view._field)
  local a, b, values = whole(object, view._field)
  local shape = {object:get_shape()}
  view._data, view._pointer = ffi.cast(bytes, data), pointers[shape[#shape]]
  view._a, view._b, view._c = a, b, values
  view._step_a, view._step_b = tonumber(strides[0]), tonumber(strides[1])
  view._step_c = view._axes == 3 and tonumber(strides[2]) or 0
  view._version = object._version
end

local function outside(i, j, k, view)
  fail(RANGE, ("view: no place (%s, %s, %s) in %d x %d x %d"):format(
    tostring(i), tostring(j), tostring(k), view._a, view._b, view._c))
end

-- The number at a place, whose indices begin with 0: view(strand, node, component).
View.__call = function(view, i, j, k)
  if view._version ~= view._object._version then refresh(view) end
  k = k or 0
  if not (i >= 0 and i < view._a and j >= 0 and j < view._b and k >= 0 and k < view._c) then outside(i, j, k, view) end
  i, j, k = math.floor(i), math.floor(j), math.floor(k)
  return tonumber(ffi.cast(view._pointer, view._data + i * view._step_a + j * view._step_b + k * view._step_c)[0])
end

-- How many places along its two directions, and how many values each has.
function View:shape()
  if self._version ~= self._object._version then refresh(self) end
  return self._a, self._b, self._c
end

function support.view(object, field, ask, axes)
  local view = setmetatable({_object = object, _field = field, _ask = ask, _axes = axes}, View)
  refresh(view)
  return view
end

-- ---- callbacks -----------------------------------------------------------------------------------------------------

local kept = {}

-- A struct of C functions that call Lua's. They are never freed, as an object may call them until its end. Compiled
-- code must not be called back from, so that from here on methods are interpreted.
function support.callbacks(c_name, functions)
  if #kept == 0 then
    for _, class in ipairs(classes) do
      for _, method in pairs(class) do
        if type(method) == "function" then jit.off(method) end
      end
    end
    jit.flush()
  end
  local struct = ffi.new(c_name)
  kept[#kept + 1] = struct
  for name, entry in pairs(functions) do
    local call = entry[2]
    local c_function = ffi.cast(entry[1], function(...)
      local done, result = pcall(call, ...)
      if done then return result end
      pending = pending or {result}
    end)
    kept[#kept + 1] = c_function
    struct[name] = c_function
  end
  return struct
end

return support
