using System;
using StandIns.Collections;

namespace Unity.Collections
{
    /// <summary>An element of a hash map, in place.</summary>
    public unsafe struct KVPair<TKey, TValue> where TKey : unmanaged, IEquatable<TKey> where TValue : unmanaged
    {
        readonly HashTable<TKey, TValue>* m_Table;
        readonly int m_Slot;

        internal KVPair(HashTable<TKey, TValue>* table, int slot)
        {
            m_Table = table;
            m_Slot = slot;
        }

        public static KVPair<TKey, TValue> Null => new KVPair<TKey, TValue>(null, -1);

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
