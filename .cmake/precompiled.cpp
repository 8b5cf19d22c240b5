// Nothing but the headers that are compiled before all others (.cmake/rooms.cmake).
