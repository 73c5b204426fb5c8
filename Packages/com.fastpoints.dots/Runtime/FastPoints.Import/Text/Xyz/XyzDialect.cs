using FastPoints.Core;


namespace FastPoints.Text
{
    /// <summary>How the values in a text file's lines are separated. Blittable; HPC#.</summary>
    struct XyzDialect
    {
        /// <summary>Replaces the separator while a line is read: a number ends at it as at a blank.</summary>
        public const byte Mark = 1;

        /// <summary>A comma or a semicolon; 0 if values are separated by blanks (spaces, tabs).</summary>
        public byte Separator;

        /// <summary>Whether 1,5 means one and a half.</summary>
        public bool HasDecimalComma;

        /// <summary>Whether values stand in double quotes.</summary>
        public bool HasQuotes;

        public string Name => (Separator == ',' ? "comma" : Separator == ';' ? "semicolon" : "blanks") +
            (HasDecimalComma ? ", decimal comma" : "") + (HasQuotes ? ", in quotes" : "");

        /// <summary>Rewrites text so that <see cref="AsciiNumber"/> can read it.</summary>
        public unsafe void Apply(byte* text, int count)
        {
            if (Separator == 0 && !HasDecimalComma && !HasQuotes)
                return;
            byte separator = Separator != 0 ? Separator : Mark;
            byte comma = HasDecimalComma ? (byte)',' : Mark;
            byte quote = HasQuotes ? (byte)'"' : Mark;
            for (int i = 0; i < count; i++)
            {
                byte b = text[i];
                b = b == separator ? Mark : b;
                b = b == comma && comma != Mark ? (byte)'.' : b;
                text[i] = b == quote && quote != Mark ? (byte)' ' : b;
            }
        }

        /// <summary>Whether a line with this first byte is a comment.</summary>
        public bool IsComment(byte first) =>
            first == '#' || first == '/' || first == '%' || first == '!' || first == ';' && Separator != ';';
    }
}
