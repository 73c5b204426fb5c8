using System;
using System.Collections.Generic;
using System.Runtime.InteropServices;

namespace Unity.Burst
{
    /// <summary>
    /// A value that jobs may write, one for each pair of context types; zero at first, never freed, as in Unity. Managed
    /// code takes it once, into a static readonly field.
    /// </summary>
    public readonly unsafe struct SharedStatic<T> where T : unmanaged
    {
        private readonly void* m_Buffer;

        private SharedStatic(void* buffer)
        {
            m_Buffer = buffer;
        }

        public ref T Data => ref *(T*)m_Buffer;

        public void* UnsafeDataPointer => m_Buffer;

        public static SharedStatic<T> GetOrCreate<TContext>(uint alignment = 0) => GetOrCreate(typeof(TContext), alignment);

        public static SharedStatic<T> GetOrCreate<TContext, TSubContext>(uint alignment = 0) =>
            GetOrCreate(typeof(TContext), typeof(TSubContext), alignment);

        public static SharedStatic<T> GetOrCreate(Type contextType, uint alignment = 0) =>
            GetOrCreate(contextType, typeof(void), alignment);

        public static SharedStatic<T> GetOrCreate(Type contextType, Type subContextType, uint alignment = 0) =>
            new SharedStatic<T>(SharedStaticMemory.GetOrCreate(contextType, subContextType, sizeof(T), alignment));
    }

    internal static unsafe class SharedStaticMemory
    {
        private static readonly Dictionary<(Type, Type), (IntPtr Address, int Bytes)> s_blocks =
            new Dictionary<(Type, Type), (IntPtr, int)>();

        internal static void* GetOrCreate(Type context, Type subContext, int bytes, uint alignment)
        {
            lock (s_blocks)
            {
                if (s_blocks.TryGetValue((context, subContext), out var block))
                {
                    if (block.Bytes != bytes)
                        throw new InvalidOperationException(
                            $"SharedStatic of {context}, {subContext} has {block.Bytes} bytes and was asked for with {bytes}");
                    return (void*)block.Address;
                }
                long align = Math.Max(16u, alignment);
                long address = (long)Marshal.AllocHGlobal((IntPtr)(bytes + align));
                address = (address + align - 1) / align * align;
                new Span<byte>((void*)address, bytes).Clear();
                s_blocks.Add((context, subContext), ((IntPtr)address, bytes));
                return (void*)address;
            }
        }
    }
}
