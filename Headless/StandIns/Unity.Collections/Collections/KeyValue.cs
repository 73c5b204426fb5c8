using System;
using StandIns.Collections;

namespace Unity.Collections.LowLevel.Unsafe
{
    /// <summary>An element of a hash map, in place.</summary>
    public unsafe struct KeyValue<TKey, TValue> where TKey : unmanaged, IEquatable<TKey> where TValue : unmanaged
    {
        readonly HashTable<TKey, TValue>* m_Table;
        readonly int m_Slot;

        internal KeyValue(HashTable<TKey, TValue>* table, int slot)
        {
            m_Table = table;
            m_Slot = slot;
        }

        public static KeyValue<TKey, TValue> Null => new KeyValue<TKey, TValue>(null, -1);

        public TKey Key => m_Slot < 0 ? default : m_Table->Keys[m_Slot];

        public ref TValue Value => ref m_Table->Values[m_Slot];

        public bool GetKeyValue(out TKey key, out TValue value)
        {
            bool exists = m_Slot >= 0;
            key = exists ? m_Table->Keys[m_Slot] : default;
            value = exists ? m_Table->Values[m_Slot] : default;
            return exists;
        }
    }
}
