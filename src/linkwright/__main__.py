from linkwright.cli import main

main()
