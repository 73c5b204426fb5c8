using System;
using System.Collections.Generic;
using System.Globalization;
using System.IO;
using System.Text;

namespace FastPoints.Editor
{
    /// <summary>Makes names for converted clouds and their handles: allowed on every system, not hidden by Unity.</summary>
    internal static class AssetNaming
    {
        public const int MaxBytes = 100; // Limit in UTF-8, without extension, that keeps paths in a project short.

        const string Empty = "cloud";
        const string NotAllowed = "<>:\"/\\|?*";

        static readonly string[] s_devices =
        {
            "CON", "PRN", "AUX", "NUL", "CVS", "COM0", "COM1", "COM2", "COM3", "COM4", "COM5", "COM6", "COM7", "COM8", "COM9",
            "LPT0", "LPT1", "LPT2", "LPT3", "LPT4", "LPT5", "LPT6", "LPT7", "LPT8", "LPT9", "CONIN$", "CONOUT$",
            "COM\u00B9", "COM\u00B2", "COM\u00B3", "LPT\u00B9", "LPT\u00B2", "LPT\u00B3",
        };

        /// <summary>The nearest safe name: composed characters, none that a system forbids, no dot, blank or tilde at an end,
        /// not the name of a device, at most <see cref="MaxBytes"/>.</summary>
        public static string Safe(string name)
        {
            var text = new StringBuilder(name.Length);
            for (int i = 0; i < name.Length; i++)
            {
                bool isPair = char.IsHighSurrogate(name[i]) && i + 1 < name.Length && char.IsLowSurrogate(name[i + 1]);
                if (isPair)
                    text.Append(name[i++]).Append(name[i]);
                else
                    text.Append(IsAllowed(name[i]) ? name[i] : '_');
            }
            string safe = Trim(Shorten(text.ToString().Normalize(NormalizationForm.FormC)));
            if (safe.Length == 0)
                return Empty;
            int stem = safe.IndexOf('.');
            string device = stem < 0 ? safe : safe.Substring(0, stem);
            bool isDevice = Array.Exists(s_devices, d => d.Equals(device.TrimEnd(), StringComparison.OrdinalIgnoreCase));
            return isDevice ? "_" + safe : safe;
        }

        /// <summary>Removes what systems dislike: Unity ignores files that begin with a dot or end with a tilde;
        /// Windows drops dots and blanks at the end.</summary>
        static string Trim(string name) =>
            name.TrimStart(' ', '.', '\u00A0', '\u3000').TrimEnd(' ', '.', '~', '\u00A0', '\u3000');

        static bool IsAllowed(char c) => !char.IsControl(c) && !char.IsSurrogate(c) && NotAllowed.IndexOf(c) < 0;

        static string Shorten(string name)
        {
            int bytes = 0;
            for (int i = 0; i < name.Length; i++)
            {
                int units = char.IsHighSurrogate(name[i]) ? 2 : 1;
                bytes += units == 2 ? 4 : name[i] < 0x80 ? 1 : name[i] < 0x800 ? 2 : 3;
                if (bytes > MaxBytes)
                    return name.Substring(0, i);
                i += units - 1;
            }
            return name;
        }
    }

    /// <summary>Finds free paths in a folder: existing names are listed once, for any number of calls.</summary>
    internal sealed class FreePaths
    {
        readonly string m_folder;
        readonly string m_extension;
        readonly HashSet<string> m_taken;
        readonly Dictionary<string, int> m_numbers = new Dictionary<string, int>(StringComparer.OrdinalIgnoreCase);

        /// <param name="taken">Paths; names that differ in case alone are the same.</param>
        public FreePaths(string folder, string extension, IEnumerable<string> taken)
        {
            m_folder = folder;
            m_extension = extension;
            m_taken = new HashSet<string>(taken, StringComparer.OrdinalIgnoreCase);
        }

        /// <summary>The path of the safe name, with a number appended if that is taken; it is reserved from now on.</summary>
        public string Next(string name)
        {
            string safe = AssetNaming.Safe(name), path = Path.Combine(m_folder, safe + m_extension);
            m_numbers.TryGetValue(safe, out int number);
            for (number = Math.Max(1, number); !m_taken.Add(path);)
                path = Path.Combine(m_folder, safe + " " + (++number).ToString(CultureInfo.InvariantCulture) + m_extension);
            m_numbers[safe] = number;
            return path;
        }
    }
}
