using System.Collections.Generic;
using FastPoints.Points;

namespace FastPoints.Files
{
    /// <summary>One element of a PLY file: how many there are, by the header, and what each holds.</summary>
    internal sealed class PlyElement
    {
        public string Name;

        /// <summary>As claimed: it may be anything.</summary>
        public ulong Count;

        public readonly List<PlyProperty> Properties = new List<PlyProperty>();

        /// <summary>Byte at which the header line starts.</summary>
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

        /// <summary>Bytes of one instance in a binary file, or -1 where lists make it vary.</summary>
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

        /// <summary>Of the value, or of a list's items.</summary>
        public AttributeType Type;

        public bool IsList;

        /// <summary>Of the number before a list's items. Always an integer.</summary>
        public AttributeType CountType;

        /// <summary>Byte at which the header line starts.</summary>
        public long LineOffset;
    }
}
