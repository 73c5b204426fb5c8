namespace FastPoints.Files
{
    /// <summary>
    /// The lines of one stretch of an ascii file, counted without knowing whether the stretch starts within a line. Lines of
    /// nothing but blanks are none.
    /// </summary>
    struct AsciiRowCount
    {
        /// <summary>Lines whose first character lies in the stretch, behind its first line end.</summary>
        public int RowsBehindFirstEnd;

        /// <summary>Whether there is a character before the first line end: a line of this stretch unless it started
        /// earlier.</summary>
        public bool HasTextBeforeFirstEnd;

        public bool HasLineEnd;

        /// <summary>Whether there is a character behind the last line end: the next stretch starts within a line.</summary>
        public bool EndsInText;
    }
}
