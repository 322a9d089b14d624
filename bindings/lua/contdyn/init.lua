-- contdyn for LuaJIT: ropes, hair, sheets and water. What a function does is told in the C header of its object, and
-- above it in contdyn/api.lua. See README.md.
local api = require("contdyn.api")
local support = require("contdyn.support")

api.Error = support.Error
api.SIZE_MAX = support.SIZE_MAX
api.library_path = support.path

return api
