-- Runs the tests: luajit bindings/lua/tests/run.lua [NAME]... (those whose names contain one of these). The library is
-- found as the package finds it: see CONTDYN_LIBRARY in README.md.
local here = arg[0]:match("^(.*[/\\])") or "./"
package.path = here .. "?.lua;" .. here .. "../?.lua;" .. here .. "../?/init.lua;" .. package.path
BINDINGS = here .. "../../"

local failed, passed = 0, 0

function test(name, run)
  local chosen = #arg == 0
  for _, word in ipairs(arg) do chosen = chosen or name:find(word, 1, true) ~= nil end
  if not chosen then return end
  local ok, what = xpcall(run, function(raised) return debug.traceback(tostring(raised), 2) end)
  if ok then
    passed = passed + 1
  else
    failed = failed + 1
    io.stderr:write("FAILED: ", name, ": ", what, "\n")
  end
end

function equal(found, wanted, what)
  if found ~= wanted then
    error(("%s%s, not %s"):format(what and what .. ": " or "", tostring(found), tostring(wanted)), 2)
  end
end

-- The call must raise an error with this status, whose message has these words.
function refused(status, words, call, ...)
  local ok, raised = pcall(call, ...)
  if ok then error("not refused: " .. status .. ", " .. words, 2) end
  if type(raised) ~= "table" then error(raised, 2) end
  equal(raised.status, status, raised.message)
  if not raised.message:find(words, 1, true) then error(("%q does not tell %q"):format(raised.message, words), 2) end
end

for _, name in ipairs {"conformance", "functions", "arrays", "callbacks", "lifetime"} do require("test_" .. name) end

print(("%d tests passed, %d failed"):format(passed, failed))
os.exit(failed == 0 and passed > 0 and 0 or 1, true)
