using System.Collections.Generic;
using FastPoints.Core;

namespace FastPoints.Ply
{
    internal sealed class PlyElement
    {
        public string Name;

        // Claimed, which may be anything.
        public ulong Count;

        public readonly List<PlyProperty> Properties = new List<PlyProperty>();
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

        // Of one instance in a binary file, or -1 if lists make it vary.
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

        // One past the file's end for any count that does not fit. Without lists only.
        public long EndOfFixed(long offset, long fileBytes)
        {
            ulong bytes = (ulong)FixedBytes;
            ulong room = offset < fileBytes ? (ulong)(fileBytes - offset) : 0;
            return bytes == 0 || Count <= room / bytes ? offset + (long)(Count * bytes) : fileBytes + 1;
        }
    }

    internal sealed class PlyProperty
    {
        public string Name;

        // Of the value, or of a list's items.
        public AttributeType Type;

        public bool IsList;

        // Of the number before a list's items, which is always an integer.
        public AttributeType CountType;

        // Its bytes are blue, green, red and perhaps alpha (PCD).
        public bool IsColor;
        public bool HasAlpha;
        public long LineOffset;
    }
}
