namespace FastPoints.Files
{
    /// <summary>What the jobs of the PLY reader report in <see cref="DecodeResult.Error"/>.</summary>
    static class PlyError
    {
        public const int None = 0;
        public const int MissingValue = 1;
        public const int BadNumber = 2;
        public const int LineTooLong = 3;
        public const int BadListLength = 4;
        public const int Truncated = 5;
        public const int RecordTooLong = 6;

        public static string Text(int error)
        {
            switch (error)
            {
                case MissingValue:
                    return "the line ends before the vertex has all its values";
                case BadNumber:
                    return "not a number";
                case LineTooLong:
                    return "the line is longer than 65,536 bytes";
                case BadListLength:
                    return "a list of negative length";
                case Truncated:
                    return "the file ends within an element";
                case RecordTooLong:
                    return "a vertex of more than 16 MiB";
                default:
                    return "error " + error;
            }
        }
    }
}
