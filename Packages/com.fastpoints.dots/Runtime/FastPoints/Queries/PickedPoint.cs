using System.Collections.Generic;
using FastPoints.Store;
using Unity.Mathematics;

namespace FastPoints.Queries
{
    /// <summary>A point of a cloud that a user has picked, with all that the cloud knows of it.</summary>
    public sealed class PickedPoint
    {
        internal PickedPoint(Grid3 position, CloudGrid grid, double3 world, double distance,
            IReadOnlyList<PickedAttribute> attributes)
        {
            Position = position;
            Grid = grid;
            PositionWorld = world;
            Distance = distance;
            Attributes = attributes;
        }

        /// <summary>Exact position in whole steps of <see cref="Grid"/>.</summary>
        public Grid3 Position { get; }

        /// <summary>The grid of the point's cloud.</summary>
        public CloudGrid Grid { get; }

        /// <summary>In CRS units: the exact position, rounded as the file's own numbers are.</summary>
        public double3 PositionGeo => Grid.ToGeo(Position);

        /// <summary>Position in the world as the cloud stood when it was picked.</summary>
        public double3 PositionWorld { get; }

        /// <summary>Distance along the ray in world units.</summary>
        public double Distance { get; }

        /// <summary>All attributes of the point except its position, in the order of the source.</summary>
        public IReadOnlyList<PickedAttribute> Attributes { get; }
    }

    internal sealed class PickResult
    {
        public PickedPoint Point { get; internal set; } // Null if nothing was hit.

        // The search ended at PickOptions.MaxBytes, so that there may be a nearer point.
        public bool IsPartial { get; internal set; }

        public int NodesRead { get; internal set; }
        public long BytesRead { get; internal set; }
    }

    /// <summary>One value of a picked point, exactly as the cloud keeps it.</summary>
    public readonly struct PickedAttribute
    {
        readonly ulong m_bits;

        /// <summary>Takes the value as it lies in a plane, and what the plane's numbers mean.</summary>
        public unsafe PickedAttribute(PointAttribute attribute, ulong packed, in StoredColumn column)
        {
            Attribute = attribute;
            ulong value = 0, bits;
            OrderedBits.Store(packed * (ulong)column.Divisor, column.Type, (byte*)&value);
            ColumnValues.ToBits((byte*)&value, column.Type, 0, 1, &bits);
            m_bits = bits;
        }

        public PointAttribute Attribute { get; }

        /// <summary>The stored number, scaled and offset; rounded if a whole number has more than 53 bits.</summary>
        public double Value => Stored * Attribute.Scale + Attribute.Offset;

        unsafe double Stored
        {
            get
            {
                ulong bits = m_bits;
                return ColumnValues.ToDouble((byte*)&bits, Attribute.Type, 0);
            }
        }

        /// <summary>The value with all of its digits.</summary>
        public override string ToString()
        {
            if (Attribute.Scale != 1 || Attribute.Offset != 0 || Attribute.Type == AttributeType.Float64)
                return NumberText.Of(Value);
            return Attribute.Type switch
            {
                AttributeType.Float32 => NumberText.Of(math.asfloat((uint)m_bits)),
                AttributeType.UInt64 => NumberText.Of(m_bits),
                _ => NumberText.Of((long)m_bits),
            };
        }
    }
}
