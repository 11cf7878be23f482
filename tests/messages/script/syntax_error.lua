-- expect: syntax_error.lua:5: '}' expected (to close '{' at line 4) near 'api'
-- as: events
local lsos = require 'lsos'
return lsos.event {
  doc = 'x' api = 1
}
