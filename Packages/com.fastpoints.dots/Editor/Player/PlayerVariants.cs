using System;
using System.Collections.Generic;
using System.IO;
using FastPoints.Base;
using FastPoints.Files;
using FastPoints.Gpu;
using FastPoints.Rendering;

namespace FastPoints.Editor
{
    /// <summary>The variants of the package's shaders that a player may use, by name: the pass and its keywords.</summary>
    internal sealed class PlayerVariants
    {
        /// <summary>Prefix of the names of the package's shaders.</summary>
        public const string ShaderPrefix = "Hidden/FastPoints/";

        const string KeywordPrefix = "FASTPOINTS_";

        readonly HashSet<string> m_names;

        public PlayerVariants() : this(new[] { NameOf("Compose", new string[0]) }) { }

        PlayerVariants(IEnumerable<string> names) => m_names = new HashSet<string>(names, StringComparer.Ordinal);

        /// <summary>Adds the variants of a style.</summary>
        /// <param name="isEver">Whether there may ever be clip boxes, hidden classes, headsets: the variants without them are
        /// needed, too.</param>
        public void Add(in PointStyle style, in DrawnOptions isEver)
        {
            for (int options = 0; options < 8; options++)
            {
                bool isClipped = (options & 1) != 0, isFiltered = (options & 2) != 0, isStereo = (options & 4) != 0;
                if (isClipped && !isEver.Clipped || isFiltered && !isEver.Filtered || isStereo && !isEver.Stereo)
                    continue;
                var variant = new PointVariant(style, isClipped, isFiltered, isStereo);
                m_names.Add(NameOf("Points", variant.Keywords));
                if (style.Shape == PointShape.Splat)
                    m_names.Add(NameOf("Blending", variant.Blending.Keywords));
            }
            if (PointVariant.ComposeKeyword(style) is { } composing)
                m_names.Add(NameOf("Compose", new[] { composing }));
        }

        /// <summary>Adds the variants of all styles.</summary>
        public void AddAll(in DrawnOptions isEver)
        {
            foreach (PointShape shape in Enum.GetValues(typeof(PointShape)))
                foreach (var mode in new[] { PointSizeMode.Pixels, PointSizeMode.Adaptive })
                    for (int edl = 0; edl < 2; edl++)
                        Add(new PointStyle { Shape = shape, Size = new PointSize { Mode = mode }, EdlStrength = edl }, isEver);
        }

        /// <summary>Whether a player may use a variant.</summary>
        public bool Contains(string name) => m_names.Contains(name);

        /// <summary>Whether another set contains all of these.</summary>
        public bool IsWithin(PlayerVariants other) => m_names.IsSubsetOf(other.m_names);

        /// <param name="keywords">Keywords in any order; those of others are ignored.</param>
        public static string NameOf(string pass, IEnumerable<string> keywords)
        {
            var own = new SortedSet<string>(StringComparer.Ordinal);
            foreach (string keyword in keywords)
                if (keyword.StartsWith(KeywordPrefix, StringComparison.Ordinal))
                    own.Add(keyword);
            return own.Count == 0 ? pass : pass + " " + string.Join(" ", own);
        }

        /// <returns>What <see cref="Write"/> wrote; null if nothing can be read.</returns>
        public static PlayerVariants Read(string path)
        {
            try
            {
                return new PlayerVariants(File.ReadAllLines(path));
            }
            catch (Exception e) when (FileFailures.IsFileFailure(e))
            {
                return null;
            }
        }

        /// <summary>Writes one line for each variant.</summary>
        /// <exception cref="PointCloudException">It cannot be written.</exception>
        public void Write(string path)
        {
            var names = new List<string>(m_names);
            names.Sort(StringComparer.Ordinal);
            try
            {
                Directory.CreateDirectory(Path.GetDirectoryName(path));
                File.WriteAllLines(path, names);
            }
            catch (Exception e) when (FileFailures.IsFileFailure(e))
            {
                throw FileFailures.Writing(path, e);
            }
        }
    }

    /// <summary>What points may be drawn with besides their style.</summary>
    internal struct DrawnOptions
    {
        /// <summary>Clip boxes.</summary>
        public bool Clipped;

        /// <summary>Hidden classes.</summary>
        public bool Filtered;

        /// <summary>Both eyes of a headset at once.</summary>
        public bool Stereo;
    }
}
