using FastPoints.Core;

namespace FastPoints.Text
{
    // How values are separated. Blittable; HPC#.
    struct XyzDialect
    {
        // Replaces the separator while a line is read: a number ends at it as at a blank.
        public const byte Mark = 1;

        // A comma or a semicolon; 0 if values are separated by blanks (spaces, tabs).
        public byte Separator;

        // 1,5 means one and a half.
        public bool HasDecimalComma;

        public bool HasQuotes;

        public string Name => (Separator == ',' ? "comma" : Separator == ';' ? "semicolon" : "blanks") +
            (HasDecimalComma ? ", decimal comma" : "") + (HasQuotes ? ", in quotes" : "");

        // Rewrites text so that AsciiNumber can read it.
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

        public bool IsComment(byte first) =>
            first == '#' || first == '/' || first == '%' || first == '!' || first == ';' && Separator != ';';
    }
}
