using System.Collections.Generic;
using FastPoints.Core;

namespace FastPoints.Ply
{
    /// <summary>One element of a PLY file: its number of instances according to the header, and what each one holds.</summary>
    internal sealed class PlyElement
    {
        public string Name;

        /// <summary>The claimed number, which may be anything.</summary>
        public ulong Count;

        public readonly List<PlyProperty> Properties = new List<PlyProperty>();

        /// <summary>Offset of its header line.</summary>
        public long LineOffset;

        public bool HasLists
        {
            get
            {
                foreach (var property in Properties)
                    if (property.IsList)
                        return true;
                return false;
            }
        }

        /// <summary>Bytes of one instance in a binary file, or -1 if lists make it vary.</summary>
        public int FixedBytes
        {
            get
            {
                int bytes = 0;
                foreach (var property in Properties)
                {
                    if (property.IsList)
                        return -1;
                    bytes += property.Type.SizeOf();
                }
                return bytes;
            }
        }

        /// <summary>Where the element ends if it starts at <paramref name="offset"/> of a file of <paramref name="fileBytes"/>;
        /// one past the file's end for any count that does not fit. Without lists only.</summary>
        public long EndOfFixed(long offset, long fileBytes)
        {
            ulong bytes = (ulong)FixedBytes;
            ulong room = offset < fileBytes ? (ulong)(fileBytes - offset) : 0;
            return bytes == 0 || Count <= room / bytes ? offset + (long)(Count * bytes) : fileBytes + 1;
        }
    }

    /// <summary>One property of a PLY element, as its header line declares it.</summary>
    internal sealed class PlyProperty
    {
        public string Name;

        /// <summary>Type of the value, or of a list's items.</summary>
        public AttributeType Type;

        public bool IsList;

        /// <summary>Type of the number before a list's items, which is always an integer.</summary>
        public AttributeType CountType;

        /// <summary>Whether its bytes are blue, green, red and perhaps alpha (PCD).</summary>
        public bool IsColor;
        public bool HasAlpha;

        /// <summary>Offset of its header line.</summary>
        public long LineOffset;
    }
}
