//! Tables as CSV (RFC 4180): a field that holds a comma, a quote or a line break is quoted.

use std::fmt::Display;

/// A table that is written row by row.
pub struct Table(csv::Writer<Vec<u8>>);

impl Table {
    /// A table of these columns, named with commas between.
    pub fn new(columns: &str) -> Self {
        let mut table = Self(csv::WriterBuilder::new().flexible(true).from_writer(Vec::new()));
        table.write(columns.split(','));
        table
    }

    /// Appends a row.
    pub fn row(&mut self, fields: &[&dyn Display]) {
        self.write(fields.iter().map(ToString::to_string));
    }

    fn write(&mut self, fields: impl Iterator<Item = impl AsRef<[u8]>>) {
        // Rows may differ in length and memory takes them all, so that nothing can fail.
        let _ = self.0.write_record(fields);
    }

    /// The whole table as text.
    pub fn into_csv(self) -> String {
        String::from_utf8(self.0.into_inner().unwrap_or_default()).unwrap_or_default()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_fields_that_need_quotes_have_them() {
        let mut table = Table::new("name,value");
        table.row(&[&"n = 1", &1e-7]);
        table.row(&[&"a \"b\", c", &f64::INFINITY]);
        table.row(&[&"", &"two\nlines"]);
        let expected = "name,value\nn = 1,0.0000001\n\"a \"\"b\"\", c\",inf\n,\"two\nlines\"\n";
        assert_eq!(table.into_csv(), expected);
    }
}
