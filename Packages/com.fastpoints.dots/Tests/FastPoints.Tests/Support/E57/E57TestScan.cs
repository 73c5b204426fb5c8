using System.Collections.Generic;

namespace FastPoints.Tests.Files
{
    /// <summary>A scan to write: fields with their values, and how they are cut into packets.</summary>
    sealed class E57TestScan
    {
        public readonly List<E57TestField> Fields = new List<E57TestField>();

        /// <summary>Elements of the scan besides guid and points: name, pose, limits.</summary>
        public string Xml = "";

        /// <summary>Attributes of the points element in place of the right ones.</summary>
        public string RecordCount;
        public string FileOffset;

        /// <summary>How packets are filled.</summary>
        public E57Packing Packing = E57Packing.Even;

        public int RecordsPerPacket = 1000;
        public bool HasIndex = true;
        public bool HasIgnored;
        public bool HasRestartFlag;

        public E57TestScan(params E57TestField[] fields) => Fields.AddRange(fields);

        public int Count => Fields[0].Count;

        public static string Pose(double w, double x, double y, double z, double tx, double ty, double tz) =>
            string.Format(System.Globalization.CultureInfo.InvariantCulture,
                "<pose type=\"Structure\"><rotation type=\"Structure\"><w type=\"Float\">{0:R}</w><x type=\"Float\">{1:R}</x>" +
                "<y type=\"Float\">{2:R}</y><z type=\"Float\">{3:R}</z></rotation><translation type=\"Structure\">" +
                "<x type=\"Float\">{4:R}</x><y type=\"Float\">{5:R}</y><z type=\"Float\">{6:R}</z></translation></pose>",
                w, x, y, z, tx, ty, tz);
    }
}
