-- expect: returns_nothing.lua: must return lsos.event {...}, found nothing
-- as: events
local lsos = require 'lsos'
local _ = lsos
