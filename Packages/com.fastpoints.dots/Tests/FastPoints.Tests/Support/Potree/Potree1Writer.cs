using System;
using System.Collections.Generic;
using System.Globalization;
using System.IO;
using System.Linq;
using System.Text;
using Unity.Mathematics;

namespace FastPoints.Tests
{
    /// <summary>Writes Potree 1 trees of BIN nodes as PotreeConverter 1.4 to 1.8 did.</summary>
    public sealed class Potree1Writer
    {
        public string Version = "1.7";
        public int StepSize = 2;
        public double Scale = 1.0 / 1024;
        public double3 Min = new double3(-5, 1024, 0.5);
        public string OctreeFolder = "data";
        public string ExtraMembers = "\"projection\": \"\",";
        public PotreeTestAttribute[] Attributes = AllNamed;

        /// <summary>Attributes that versions before 1.8 know by name.</summary>
        public static readonly PotreeTestAttribute[] AllNamed =
        {
            new PotreeTestAttribute("POSITION_CARTESIAN", "int32", 3), new PotreeTestAttribute("COLOR_PACKED", "uint8", 4),
            new PotreeTestAttribute("INTENSITY", "uint16"), new PotreeTestAttribute("CLASSIFICATION", "uint8"),
            new PotreeTestAttribute("NORMAL_OCT16", "uint8", 2), new PotreeTestAttribute("RETURN_NUMBER", "uint8"),
            new PotreeTestAttribute("NUMBER_OF_RETURNS", "uint8"), new PotreeTestAttribute("SOURCE_ID", "uint16"),
            new PotreeTestAttribute("GPS_TIME", "double"), new PotreeTestAttribute("INDICES", "uint32"),
            new PotreeTestAttribute("SPACING", "float"),
        };

        bool IsFlat => Version == "1.4";

        public void Write(TemporaryFolder folder, PotreeTestCloud cloud)
        {
            folder.Write("cloud.js", CloudJs(cloud));
            foreach (var node in cloud.PointsOfNode)
                folder.Write(OctreeFolder + "/" + PathOf(node.Key) + ".bin", Records(cloud, node.Key, node.Value));
            if (!IsFlat)
                foreach (string root in cloud.PointsOfNode.Keys.Where(name => (name.Length - 1) % StepSize == 0))
                    folder.Write(OctreeFolder + "/" + PathOf(root) + ".hrc", Hierarchy(cloud, root));
        }

        public string PathOf(string node)
        {
            if (IsFlat)
                return node;
            string path = "r/";
            for (int at = 1; at + StepSize <= node.Length; at += StepSize)
                path += node.Substring(at, StepSize) + "/";
            return path + node;
        }

        byte[] Records(PotreeTestCloud cloud, string node, List<int> points)
        {
            var bytes = new MemoryStream();
            var corner = Min + PotreeTestCloud.Corner(node) * Scale;
            foreach (int point in points)
                foreach (var attribute in Attributes)
                    bytes.Write(Bytes(cloud, point, attribute, corner), 0, attribute.Bytes);
            return bytes.ToArray();
        }

        byte[] Bytes(PotreeTestCloud cloud, int point, PotreeTestAttribute attribute, double3 corner)
        {
            var bytes = new byte[attribute.Bytes];
            if (attribute.Name == "POSITION_CARTESIAN")
            {
                var geo = Min + (double3)cloud.Position(point) * Scale;
                for (int axis = 0; axis < 3; axis++)
                    BitConverter.GetBytes((int)((geo[axis] - corner[axis]) / Scale)).CopyTo(bytes, 4 * axis);
                return bytes;
            }
            if (attribute.Name == "INDICES")
                return BitConverter.GetBytes(point);
            for (int i = 0; i < bytes.Length; i++)
                bytes[i] = PotreeTestCloud.ByteOf(point, attribute.Name, i);
            return bytes;
        }

        byte[] Hierarchy(PotreeTestCloud cloud, string root)
        {
            var bytes = new MemoryStream();
            var writer = new BinaryWriter(bytes);
            foreach (var node in cloud.PointsOfNode)
                if (node.Key.StartsWith(root, StringComparison.Ordinal) && node.Key.Length - root.Length <= StepSize)
                {
                    writer.Write((byte)cloud.ChildMask(node.Key));
                    writer.Write((uint)node.Value.Count);
                }
            return bytes.ToArray();
        }

        string CloudJs(PotreeTestCloud cloud)
        {
            var max = Min + PotreeTestCloud.Edge * Scale;
            string box = string.Format(CultureInfo.InvariantCulture,
                "{{ \"lx\": {0:R}, \"ly\": {1:R}, \"lz\": {2:R}, \"ux\": {3:R}, \"uy\": {4:R}, \"uz\": {5:R}, }}",
                Min.x, Min.y, Min.z, max.x, max.y, max.z);
            var text = new StringBuilder("{ \"version\": \"" + Version + "\", \"octreeDir\": \"" + OctreeFolder + "\", "
                + ExtraMembers + " \"boundingBox\": " + box + ", \"tightBoundingBox\": " + box + ", \"pointAttributes\": [");
            foreach (var attribute in Attributes)
                text.Append(Version == "1.8"
                    ? "{ \"name\": \"" + attribute.Name + "\", \"size\": " + attribute.Bytes
                        + ", \"elements\": " + attribute.Elements
                        + ", \"elementSize\": " + attribute.ElementBytes + ", \"type\": \"" + attribute.Type
                        + "\", \"description\": \"\" },"
                    : "\"" + attribute.Name + "\",");
            text.Append("], \"spacing\": 0.1, \"scale\": " + Scale.ToString("R", CultureInfo.InvariantCulture) + ", ");
            if (IsFlat)
            {
                text.Append("\"hierarchy\": [");
                foreach (var node in cloud.PointsOfNode)
                    text.Append("[\"" + node.Key + "\", " + node.Value.Count + "],");
                text.Append("], ");
            }
            return text.Append("\"hierarchyStepSize\": " + StepSize + ", }").ToString();
        }
    }
}
