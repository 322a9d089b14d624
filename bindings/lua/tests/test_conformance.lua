-- The scenes of bindings/conformance: the same hashes as in every other language.
local contdyn = require("contdyn")

local function text_of(path)
  local file = assert(io.open(path))
  local text = file:read("*a")
  file:close()
  return text
end

local enumerators = {}
local described = '"name": "(CD_[%w_]+)",%s+"short": "[%w_]+",%s+"value": (%d+)'
for name, value in text_of(BINDINGS .. "api.json"):gmatch(described) do
  enumerators[name] = tonumber(value)
end

-- Line and words of each statement; lines that begin with a space go on with it.
local function statements()
  local found, number = {}, 0
  for line in (text_of(BINDINGS .. "conformance/scenes.txt") .. "\n"):gmatch("(.-)\n") do
    number = number + 1
    if line ~= "" and line:sub(1, 1) ~= "#" then
      if line:sub(1, 1) ~= " " then found[#found + 1] = {line = number} end
      for word in line:gmatch("%S+") do table.insert(found[#found], word) end
    end
  end
  return found
end

-- The words from the k-th on as Lua has them, and how many they are.
local function arguments(words, k, precision)
  local taken, count, into = {}, 0, nil
  for i = k, #words do
    local word, value = words[i], nil
    if word == "[" then
      into = {}
      count = count + 1
      taken[count] = into
    elseif word == "]" then
      into = nil
    else
      if word == "precision" then value = precision
      elseif word == "INFINITY" then value = math.huge
      elseif word ~= "null" then value = enumerators[word] or assert(tonumber(word), word) end
      if into then
        into[#into + 1] = value
      else
        count = count + 1
        taken[count] = value
      end
    end
  end
  return taken, count
end

local classes = {chain = contdyn.Chain, membrane = contdyn.Membrane, water = contdyn.Water}

local function play(precision, kernels)
  local compared, object, made_by = 0, nil, nil
  local function make()
    local taken, count = arguments(made_by, 3, precision)
    local made = classes[made_by[2]].create(unpack(taken, 1, count))
    made:set_kernels(kernels)
    return made
  end
  local function call(words, k)
    local taken, count = arguments(words, k + 1, precision)
    return object[words[k]](object, unpack(taken, 1, count))
  end
  local special = {
    scene = function() object = nil end,
    create = function(words)
      made_by = words
      object = make()
    end,
    copy = function()
      local last = object
      object = make()
      object:copy_state(last)
    end,
    save_and_load = function()
      local last = object
      object = make()
      object:load(last:save())
    end,
    hash = function(words)
      equal(("0x%s"):format(bit.tohex(object:hash())), words[2 + precision])
      compared = compared + 1
    end,
    refused = function(words)
      local status = words[2]:lower():gsub("^cd_", "")
      refused(status, "cd_" .. made_by[2] .. "_", call, words, 3)
    end,
  }
  for _, words in ipairs(statements()) do
    local ok, raised = pcall(special[words[1]] or function() call(words, 1) end, words)
    if not ok then error(("line %d: %s"):format(words.line, tostring(raised))) end
  end
  return compared
end

test("conformance", function()
  local compared, runnable = 0, contdyn.runnable_kernels()
  for kernels = 0, 31 do
    if bit.band(runnable, bit.lshift(1, kernels)) ~= 0 then
      for precision = 0, 1 do compared = compared + play(precision, kernels) end
    end
  end
  assert(compared > 10)
  print(compared .. " hashes compared")
end)

test("another step is another hash", function()
  local rope = contdyn.Chain(1, 12, 2)
  local before = rope:hash()
  rope:step(0.01, 1)
  assert(rope:hash() ~= before)
end)
