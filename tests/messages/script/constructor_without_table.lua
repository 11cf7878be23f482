-- expect: constructor_without_table.lua:4: lsos.event takes a table, lsos.event {...}, found nothing
-- as: events
local lsos = require 'lsos'
return lsos.event()
