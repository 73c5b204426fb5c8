using System;
using System.Globalization;
using System.Text;
using FastPoints.Core;

namespace FastPoints.E57
{
    static class E57Text
    {
        const int MaxShownChars = 400;

        static readonly DateTime s_gpsEpoch = new DateTime(1980, 1, 6, 0, 0, 0, DateTimeKind.Utc);

        public static bool TryInteger(string text, long missing, out long value)
        {
            value = missing;
            if (string.IsNullOrWhiteSpace(text))
                return true;
            return long.TryParse(text.Trim(), NumberStyles.AllowLeadingSign, CultureInfo.InvariantCulture, out value);
        }

        public static bool TryReal(string text, double missing, out double value)
        {
            value = missing;
            if (string.IsNullOrWhiteSpace(text))
                return true;
            return NumberText.TryRead(text.Trim(), out value);
        }

        public static bool TryCount(string text, out ulong value) =>
            ulong.TryParse(text?.Trim(), NumberStyles.None, CultureInfo.InvariantCulture, out value);

        // No line ends, nothing unprintable, not longer than a few lines.
        public static string OneLine(string text)
        {
            var line = new StringBuilder(Math.Min(text.Length, MaxShownChars));
            bool isBlank = true;
            foreach (char c in text)
            {
                if (line.Length == MaxShownChars)
                    return line.Append("...").ToString();
                bool isSpace = char.IsWhiteSpace(c) || char.IsControl(c);
                if (isSpace && isBlank)
                    continue;
                line.Append(isSpace ? ' ' : c);
                isBlank = isSpace;
            }
            return line.ToString().TrimEnd();
        }

        // A dateTimeValue: GPS time counts no leap seconds.
        public static string GpsTime(double seconds) =>
            seconds > 0 && seconds < 1e10
                ? s_gpsEpoch.AddSeconds(seconds).ToString("yyyy-MM-dd HH:mm:ss", CultureInfo.InvariantCulture) + " GPS time"
                : NumberText.Of(seconds) + " s of GPS time";
    }
}
