using System.Runtime.CompilerServices;

namespace FastPoints.Store
{
    // Any attribute type as unsigned numbers in the same order, so that neighbours differ by little: signed ones have their
    // sign bit flipped; positive floats too, and negative floats have all bits flipped. No bit is lost, even of NaN and
    // negative zero.
    internal static unsafe class OrderedBits
    {
        // At an address of any alignment.
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static ulong Load(byte* value, AttributeType type)
        {
            switch (type)
            {
                case AttributeType.UInt8: return *value;
                case AttributeType.Int8: return (byte)(*value ^ 0x80);
                case AttributeType.UInt16: return *(ushort*)value;
                case AttributeType.Int16: return (ushort)(*(ushort*)value ^ 0x8000);
                case AttributeType.UInt32: return *(uint*)value;
                case AttributeType.Int32: return *(uint*)value ^ 0x80000000u;
                case AttributeType.UInt64: return *(ulong*)value;
                case AttributeType.Int64: return *(ulong*)value ^ 1UL << 63;
                case AttributeType.Float32:
                    uint single = *(uint*)value;
                    return single ^ ((uint)((int)single >> 31) | 0x80000000u);
                default:
                    ulong wide = *(ulong*)value;
                    return wide ^ ((ulong)((long)wide >> 63) | 1UL << 63);
            }
        }

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static void Store(ulong bits, AttributeType type, byte* value)
        {
            switch (type)
            {
                case AttributeType.UInt8: *value = (byte)bits; break;
                case AttributeType.Int8: *value = (byte)(bits ^ 0x80); break;
                case AttributeType.UInt16: *(ushort*)value = (ushort)bits; break;
                case AttributeType.Int16: *(ushort*)value = (ushort)(bits ^ 0x8000); break;
                case AttributeType.UInt32: *(uint*)value = (uint)bits; break;
                case AttributeType.Int32: *(uint*)value = (uint)bits ^ 0x80000000u; break;
                case AttributeType.UInt64: *(ulong*)value = bits; break;
                case AttributeType.Int64: *(ulong*)value = bits ^ 1UL << 63; break;
                case AttributeType.Float32:
                    uint single = (uint)bits;
                    *(uint*)value = single ^ (~(uint)((int)single >> 31) | 0x80000000u);
                    break;
                default:
                    *(ulong*)value = bits ^ (~(ulong)((long)bits >> 63) | 1UL << 63);
                    break;
            }
        }
    }
}
