//! Tables with named columns: as text, and as CSV (RFC 4180; a field with a comma, a quote or a line break is quoted).

use std::borrow::Cow;

/// A table; a column may be for people, for files, or for both.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Table {
    pub columns: Vec<Column>,
    pub rows: Vec<Vec<Cell>>,
}

/// A column.
#[derive(Clone, Debug)]
pub struct Column {
    /// Its name in files, where it is written to files.
    pub key: Option<Cow<'static, str>>,
    /// Its name for people, where people are shown it.
    pub head: Option<Cow<'static, str>>,
    /// How people are shown its numbers; files have all digits.
    pub show: fn(f64) -> String,
}

/// What stands in a row under a column.
#[derive(Clone, Debug, PartialEq)]
pub enum Cell {
    Empty,
    Text(String),
    Number(f64),
    Count(u64),
}

/// A row of cells.
macro_rules! cells {
    ($($cell:expr),* $(,)?) => { vec![$($crate::analysis::Cell::from($cell)),*] };
}
pub(crate) use cells;

/// A number with as many digits as it has.
pub fn as_it_is(value: f64) -> String {
    value.to_string()
}

/// A number with so many decimals.
pub fn fixed<const DECIMALS: usize>(value: f64) -> String {
    format!("{value:.DECIMALS$}")
}

impl Column {
    /// A column for files.
    pub fn key(key: impl Into<Cow<'static, str>>) -> Self {
        Self { key: Some(key.into()), head: None, show: as_it_is }
    }

    /// A column for people.
    pub fn shown(head: impl Into<Cow<'static, str>>, show: fn(f64) -> String) -> Self {
        Self { key: None, head: Some(head.into()), show }
    }

    /// A column for both.
    pub fn both(key: &'static str, head: &'static str, show: fn(f64) -> String) -> Self {
        Self { key: Some(key.into()), head: Some(head.into()), show }
    }
}

impl PartialEq for Column {
    fn eq(&self, other: &Self) -> bool {
        (&self.key, &self.head) == (&other.key, &other.head)
    }
}

impl Table {
    pub fn new(columns: impl IntoIterator<Item = Column>) -> Self {
        Self { columns: columns.into_iter().collect(), rows: Vec::new() }
    }

    pub fn has_keys(&self) -> bool {
        self.columns.iter().any(|column| column.key.is_some())
    }

    /// The heads that people see, and the rows below them; and whether each column holds numbers.
    pub fn for_people(&self) -> (Vec<&str>, Vec<Vec<String>>, Vec<bool>) {
        let shown: Vec<(usize, &Column)> =
            self.columns.iter().enumerate().filter(|(_, column)| column.head.is_some()).collect();
        let heads = shown.iter().filter_map(|(_, column)| column.head.as_deref()).collect();
        let cell = |row: &[Cell], (index, column): &(usize, &Column)| match row.get(*index) {
            Some(Cell::Text(text)) => text.clone(),
            Some(Cell::Number(value)) => (column.show)(*value),
            Some(Cell::Count(count)) => count.to_string(),
            Some(Cell::Empty) | None => "–".to_owned(),
        };
        let rows = self.rows.iter().map(|row| shown.iter().map(|column| cell(row, column)).collect()).collect();
        let text = |index: usize| self.rows.iter().any(|row| matches!(row.get(index), Some(Cell::Text(_))));
        (heads, rows, shown.iter().map(|(index, _)| !text(*index)).collect())
    }

    /// The table for a terminal; nothing where no column is for people.
    pub fn text(&self) -> String {
        let (heads, rows, numbers) = self.for_people();
        let heads: Vec<String> = heads.into_iter().map(str::to_owned).collect();
        let lines = || std::iter::once(&heads).filter(|heads| heads.iter().any(|head| !head.is_empty())).chain(&rows);
        let width = |column: usize| lines().map(|line| line[column].chars().count()).max().unwrap_or(0);
        let widths: Vec<usize> = (0..heads.len()).map(width).collect();
        let mut text = String::new();
        for line in lines().filter(|line| !line.is_empty()) {
            let mut row = String::new();
            for ((cell, width), number) in line.iter().zip(&widths).zip(&numbers) {
                row += &if *number { format!("  {cell:>width$}") } else { format!("  {cell:width$}") };
            }
            text += row.trim_end();
            text.push('\n');
        }
        text
    }

    /// The columns with keys, with all digits.
    pub fn to_csv(&self) -> String {
        let kept = || self.columns.iter().zip(0..).filter_map(|(column, index)| Some((column.key.as_deref()?, index)));
        let field = |cell: Option<&Cell>| match cell {
            Some(Cell::Text(text)) => text.clone(),
            Some(Cell::Number(value)) => value.to_string(),
            Some(Cell::Count(count)) => count.to_string(),
            Some(Cell::Empty) | None => String::new(),
        };
        let mut writer = csv::Writer::from_writer(Vec::new());
        // Memory takes every row, and all have one length: nothing can fail.
        let _ = writer.write_record(kept().map(|(key, _)| key));
        for row in &self.rows {
            let _ = writer.write_record(kept().map(|(_, index): (_, usize)| field(row.get(index))));
        }
        String::from_utf8(writer.into_inner().unwrap_or_default()).unwrap_or_default()
    }
}

impl From<f64> for Cell {
    fn from(value: f64) -> Self {
        Self::Number(value)
    }
}

impl From<u32> for Cell {
    fn from(count: u32) -> Self {
        Self::Count(count.into())
    }
}

impl From<u64> for Cell {
    fn from(count: u64) -> Self {
        Self::Count(count)
    }
}

impl From<usize> for Cell {
    fn from(count: usize) -> Self {
        Self::Count(count as u64)
    }
}

impl From<&str> for Cell {
    fn from(text: &str) -> Self {
        Self::Text(text.to_owned())
    }
}

impl From<String> for Cell {
    fn from(text: String) -> Self {
        Self::Text(text)
    }
}

impl<T: Into<Self>> From<Option<T>> for Cell {
    fn from(value: Option<T>) -> Self {
        value.map_or(Self::Empty, Into::into)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn table() -> Table {
        let mut table = Table::new([
            Column::both("name", "name", as_it_is),
            Column::both("value", "size", fixed::<2>),
            Column::key("code"),
            Column::shown("note", as_it_is),
        ]);
        table.rows.push(cells!["n = 1", 1e-7, 3_u32, "a"]);
        table.rows.push(cells!["a \"b\", c", f64::INFINITY, None::<u32>, "b"]);
        table.rows.push(cells!["", "two\nlines", 0_u64, ""]);
        table
    }

    #[test]
    fn files_have_all_digits_and_only_fields_that_need_quotes_have_them() {
        let expected = "name,value,code\nn = 1,0.0000001,3\n\"a \"\"b\"\", c\",inf,\n,\"two\nlines\",0\n";
        assert_eq!(table().to_csv(), expected);
    }

    #[test]
    fn people_have_columns_of_one_width() {
        let mut table = table();
        table.rows.pop();
        assert_eq!(table.text(), "  name      size  note\n  n = 1     0.00  a\n  a \"b\", c   inf  b\n");
    }
}
