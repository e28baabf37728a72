language-system = 系統
