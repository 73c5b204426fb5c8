using System.IO.Compression;
using Microsoft.Data.Sqlite;

namespace FastPoints.RepoTools.Epsg;

/// <summary>Makes the package's table of EPSG's coordinate systems from PROJ's database.</summary>
public static class EpsgCommand
{
    private const int LineBytes = 120;

    // Its tables name a unit for each axis; systems whose axes differ in it, as some seismic grids, have none.
    private const string Systems = """
        select c.code, c.type, c.name, s.type, p.coordinate_system_code from crs_view c
        join projected_crs p on p.auth_name = c.auth_name and p.code = c.code
        join coordinate_system s on s.auth_name = 'EPSG' and s.code = p.coordinate_system_code where c.auth_name = 'EPSG'
        union all
        select c.code, c.type, c.name, s.type, g.coordinate_system_code from crs_view c
        join geodetic_crs g on g.auth_name = c.auth_name and g.code = c.code
        join coordinate_system s on s.auth_name = 'EPSG' and s.code = g.coordinate_system_code where c.auth_name = 'EPSG'
        union all
        select c.code, c.type, c.name, s.type, v.coordinate_system_code from crs_view c
        join vertical_crs v on v.auth_name = c.auth_name and v.code = c.code
        join coordinate_system s on s.auth_name = 'EPSG' and s.code = v.coordinate_system_code where c.auth_name = 'EPSG'
        """;

    public static ToolResult Run(Repository repository, string database)
    {
        if (!File.Exists(database))
            throw new ToolException($"{database} is not there: Debian's proj-data has it");
        using var connection = new SqliteConnection($"Data Source={database};Mode=ReadOnly");
        connection.Open();
        var kinds = new List<string>();
        var entries = new SortedDictionary<int, (byte[] Bytes, string Name)>();
        var axes = Axes(connection);
        foreach (object[] row in Rows(connection, Systems))
        {
            string kind = $"{KindOf((string)row[1])} {axes[(long)row[4]]}";
            // In geocentric systems no axis points up.
            kind = kind[0] == 'C' ? kind[..kind.LastIndexOf(' ')] : kind;
            if (!kinds.Contains(kind))
                kinds.Add(kind);
            entries.Add((int)(long)row[0], (new[] { checked((byte)kinds.IndexOf(kind)) }, (string)row[2]));
        }
        foreach (object[] row in Rows(connection, "select code, name, horiz_crs_code, vertical_crs_code from compound_crs "
            + "where auth_name = 'EPSG' and horiz_crs_auth_name = 'EPSG' and vertical_crs_auth_name = 'EPSG'"))
        {
            int horizontal = (int)(long)row[2], vertical = (int)(long)row[3];
            entries.Add((int)(long)row[0], (new byte[] { byte.MaxValue, (byte)horizontal, (byte)(horizontal >> 8),
                (byte)vertical, (byte)(vertical >> 8) }, (string)row[1]));
        }
        string version = string.Join(", ", Rows(connection, "select key, value from metadata where key in "
            + "('PROJ.VERSION', 'EPSG.VERSION', 'EPSG.DATE') order by key desc").Select(r => $"{r[0]} {r[1]}"));
        string path = Path.Combine(repository.PackageRoot, "Runtime", "FastPoints.Import", "Reading", "EpsgTable.g.cs");
        File.WriteAllText(path, Source(version, Units(connection, kinds), kinds, entries));
        return new ToolResult($"{entries.Count} systems of {version}, {kinds.Count} kinds, {new FileInfo(path).Length} bytes",
            System.Array.Empty<string>());
    }

    // Such as "9003 E N", "9102 N E 9001": code of the unit, directions, and the unit of a third axis.
    private static Dictionary<long, string> Axes(SqliteConnection connection) => Rows(connection, "select "
        + "coordinate_system_code, orientation, uom_code from axis where coordinate_system_auth_name = 'EPSG' "
        + "and uom_auth_name = 'EPSG' order by coordinate_system_code, coordinate_system_order")
        .GroupBy(r => (long)r[0]).ToDictionary(g => g.Key, g => UnitsAndDirections(g.ToList()));

    private static string UnitsAndDirections(List<object[]> axes)
    {
        string[] units = axes.Select(a => a[2].ToString()!).ToArray();
        string text = units.Take(2).Distinct().Count() == 1 ? units[0] : "0";
        foreach (object[] axis in axes.Take(2))
            text += " " + DirectionOf((string)axis[1]);
        return units.Length > 2 ? text + " " + units[2] : text;
    }

    private static string DirectionOf(string orientation) => orientation switch
    {
        "east" => "E",
        "north" => "N",
        "west" => "W",
        "south" => "S",
        "up" => "U",
        "down" => "D",
        _ => "-",
    };

    private static string KindOf(string type) => type switch
    {
        "projected" => "P",
        "geographic 2D" or "geographic 3D" => "G",
        "geocentric" => "C",
        "vertical" => "V",
        _ => throw new ToolException($"a system of the kind {type}"),
    };

    private static string Units(SqliteConnection connection, List<string> kinds)
    {
        HashSet<string> used = kinds.SelectMany(k => k.Split(' ')).ToHashSet();
        return string.Join(";", Rows(connection, "select code, type, conv_factor from unit_of_measure "
            + "where auth_name = 'EPSG' and type in ('length', 'angle') order by code")
            .Where(r => used.Contains(r[0].ToString()!) || (string)r[1] == "length" && (long)r[0] is > 9000 and < 9100)
            // Degrees have many units: one for each way to write them.
            .Select(r => r[0] + " " + ((string)r[1] == "length" ? ((double)r[2]).ToString("R", CultureInfo.InvariantCulture)
                : (long)r[0] is 9102 or 9107 or 9108 or 9122 or > 9114 and < 9121 ? "deg" : "0")));
    }

    private static IEnumerable<object[]> Rows(SqliteConnection connection, string query)
    {
        using SqliteCommand command = connection.CreateCommand();
        command.CommandText = query;
        using SqliteDataReader reader = command.ExecuteReader();
        while (reader.Read())
        {
            var row = new object[reader.FieldCount];
            reader.GetValues(row);
            yield return row;
        }
    }

    private static string Source(string version, string units, List<string> kinds,
        SortedDictionary<int, (byte[] Bytes, string Name)> entries)
    {
        var codes = new List<byte>();
        int last = 0;
        foreach (var (code, entry) in entries)
        {
            for (int step = code - last; ; step >>= 7)
            {
                codes.Add((byte)(step & 127 | (step > 127 ? 128 : 0)));
                if (step <= 127)
                    break;
            }
            codes.AddRange(entry.Bytes);
            last = code;
        }
        using var names = new MemoryStream();
        using (var deflate = new DeflateStream(names, CompressionLevel.SmallestSize, true))
            deflate.Write(Encoding.UTF8.GetBytes(string.Join("\n", entries.Values.Select(e => e.Name))));
        return EmbeddedText.Of("EpsgTable.txt", ("Version", version), ("Units", units), ("Kinds", string.Join(";", kinds)),
            ("Codes", Lines(codes.ToArray())), ("Names", Lines(names.ToArray())));
    }

    private static string Lines(byte[] bytes) => string.Join(" +\n", Convert.ToBase64String(bytes).Chunk(LineBytes)
        .Select(line => "            \"" + new string(line) + "\""));
}
