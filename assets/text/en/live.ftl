# The live class: what phones are told, and the lecturer.

# Why a phone's request is refused.
live-no-student = You have not joined this class: open its page again.
live-not-open = This question is not open.
live-unfit = This answer does not fit the question.
live-too-fast = Too many requests at once: try again in a second.
live-full = The class is full.
live-not-yet = The lecturer has not shown this yet.
live-nothing = There is nothing here. Check the address on the wall.
live-malformed = The request cannot be read.
live-too-long = The request is too long.
live-too-slow = The request took too long: try again.
live-not-written = The answer could not be saved on the lecturer’s computer ({ $error }). Try again.
live-over = The class is over.
live-no-lab = The lab is not on this computer: the lecturer can start the class with --page and the folder of the web page.

# What the lecturer is told.
live-no-question = this step asks nothing
live-asks-nothing = the lesson asks nothing, expected one with questions
live-goes-on = going on with the class in { $file } ({ $students ->
    [0] no answers yet
    [one] 1 student has answered
   *[other] { $students } students have answered
 }); for a new class name another file with --output
live-no-network = no network: phones do not reach this computer. Join the room’s network or open a hotspot and start again, or give the address with --url
live-lab-missing = the files of the web page were not found, so phones cannot open the lab: give their folder with --page. All else works
live-record-unwritable = { $file }: the record cannot be written ({ $error }); name another file with --output
live-record-no-file = { $file }: not a file, expected one for the record; name another with --output
live-record-in-use = { $file } is in use by another class: name another file with --output
live-record-other = it is the record of another class, “{ $title }”, or of another version or language of the lesson
live-record-unsound = { $file }: { $error }; name another file with --output
live-no-port = no free port from { $from } to { $to }: name one with --port
live-port-taken = port { $port } is in use: name another with --port, or leave it out
live-port-refused = port { $port } cannot be opened ({ $error }): name another with --port
live-no-address = this computer does not have the address { $address }: leave out --bind, or name one that it has
live-no-server = the server cannot be started ({ $error })
live-not-now = this cannot be done now
live-no-command = “{ $word }” is not known, expected show, again, explain, next, back or end
live-rehearsed = Student { $number }
