using FastPoints.Base;

namespace FastPoints.Files
{
    /// <summary>How the values of a text file's lines are set apart. Blittable; HPC#.</summary>
    struct XyzDialect
    {
        /// <summary>What stands for the separator while a line is read: a number ends at it as at a blank.</summary>
        public const byte Mark = 1;

        /// <summary>A comma or a semicolon; 0 where values stand between blanks (spaces, tabs).</summary>
        public byte Separator;

        /// <summary>Whether 1,5 is one and a half.</summary>
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

        /// <summary>Whether a line with this first byte is a remark.</summary>
        public bool IsRemark(byte first) =>
            first == '#' || first == '/' || first == '%' || first == '!' || first == ';' && Separator != ';';
    }
}
