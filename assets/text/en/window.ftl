language-system = System
