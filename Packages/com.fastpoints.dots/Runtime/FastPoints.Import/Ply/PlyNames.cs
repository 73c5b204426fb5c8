using System;
using System.Collections.Generic;
using FastPoints.Core;
using FastPoints.Reading;

namespace FastPoints.Ply
{
    // What writers call vertex properties; case is ignored. All others keep the name in the file.
    internal static class PlyNames
    {
        // Rows that only count if all their names are present: "r" alone may be a radius.
        static readonly string[][] s_groups =
        {
            new[] { "x", AttributeNames.X }, new[] { "y", AttributeNames.Y }, new[] { "z", AttributeNames.Z },
            new[] { "red", AttributeNames.Red }, new[] { "green", AttributeNames.Green }, new[] { "blue", AttributeNames.Blue },
            new[]
            {
                "diffuse_red", AttributeNames.Red, "diffuse_green", AttributeNames.Green, "diffuse_blue", AttributeNames.Blue,
            },
            new[] { "r", AttributeNames.Red, "g", AttributeNames.Green, "b", AttributeNames.Blue },
            new[] { "alpha", AttributeNames.Alpha }, new[] { "diffuse_alpha", AttributeNames.Alpha },
            new[] { "r", "", "g", "", "b", "", "a", AttributeNames.Alpha },
            new[] { "nx", AttributeNames.NormalX, "ny", AttributeNames.NormalY, "nz", AttributeNames.NormalZ },
            new[]
            {
                "normal_x", AttributeNames.NormalX, "normal_y", AttributeNames.NormalY, "normal_z", AttributeNames.NormalZ,
            },
            new[] { "intensity", AttributeNames.Intensity }, new[] { "scalar_intensity", AttributeNames.Intensity },
            new[] { "reflectance", AttributeNames.Intensity },
        };

        // Null for lists. No name comes twice: of several candidates the first row of the table wins, and a name that the file
        // repeats gets a number.
        public static string[] Of(PlyElement vertex)
        {
            var properties = vertex.Properties;
            var indexOfName = new Dictionary<string, int>(StringComparer.OrdinalIgnoreCase);
            for (int i = 0; i < properties.Count; i++)
                if (!properties[i].IsList && !indexOfName.ContainsKey(properties[i].Name))
                    indexOfName.Add(properties[i].Name, i);

            var names = new string[properties.Count];
            var taken = new HashSet<string>();
            foreach (var group in s_groups)
                AssignGroup(group, indexOfName, names, taken);
            for (int i = 0; i < names.Length; i++)
            {
                if (names[i] != null || properties[i].IsList)
                    continue;
                names[i] = CommonNames.Of(properties[i].Name);
                if (names[i] != null && taken.Add(names[i]))
                    continue;
                string name = properties[i].Name;
                for (int n = 2; !taken.Add(name); n++)
                    name = properties[i].Name + "_" + n;
                names[i] = name;
            }
            return names;
        }

        static void AssignGroup(string[] group, Dictionary<string, int> indexOfName, string[] names, HashSet<string> taken)
        {
            for (int i = 0; i < group.Length; i += 2)
                if (!indexOfName.ContainsKey(group[i]) || taken.Contains(group[i + 1]))
                    return;
            for (int i = 0; i < group.Length; i += 2)
            {
                if (group[i + 1].Length == 0)
                    continue;
                names[indexOfName[group[i]]] = group[i + 1];
                taken.Add(group[i + 1]);
            }
        }
    }
}
