using System;
using System.Collections.Generic;
using FastPoints.Core;
using FastPoints.Reading;
using Unity.Collections;

namespace FastPoints.Octrees
{
    internal static class TreeTop
    {
        const int MaxSlots = 8;

        // Coroutine, after FindTop. Whole nodes until there are as many points as wanted; who gets the batch owns it.
        public static IEnumerator<JobStep> Read(PointReader reader, string[] attributes, int wanted, Action<PointBatch> read)
        {
            var blocks = new List<int>();
            int points = 0, max = 1;
            for (int node = 0; node < reader.Tree.NodeCount && points < wanted; node++)
            {
                if (reader.Tree[node].Block < 0)
                    continue;
                blocks.Add(reader.Tree[node].Block);
                points += reader.Tree[node].PointCount;
                max = Math.Max(max, reader.Tree[node].PointCount);
            }
            var names = new List<string> { AttributeNames.X, AttributeNames.Y, AttributeNames.Z };
            names.AddRange(attributes);
            var schema = reader.Info.Schema.Select(names.ToArray());
            var top = new PointBatch(schema, Math.Max(1, points), Allocator.Persistent);
            var slots = new BlockRead[Math.Min(MaxSlots, blocks.Count)];
            bool isDone = false;
            try
            {
                yield return JobStep.Of(SlotRing.Run(slots.Length, blocks.Count, (slot, i) =>
                {
                    slots[slot] ??= reader.CreateRead(schema, max, Allocator.Persistent);
                    slots[slot].Begin(new BlockRange(blocks[i], 0, reader.PointsInBlock(blocks[i])));
                    return slots[slot].Decoded;
                }, slot =>
                {
                    slots[slot].Complete();
                    Append(slots[slot].Points, top);
                }));
                isDone = true;
            }
            finally
            {
                foreach (var slot in slots)
                    slot?.Dispose();
                if (!isDone)
                    top.Dispose();
            }
            read(top);
        }

        static void Append(PointBatch from, PointBatch to)
        {
            for (int c = 0; c < to.Schema.Count; c++)
            {
                int size = to.Schema[c].Type.SizeOf();
                NativeArray<byte>.Copy(from.Bytes, from.Column(c).OffsetBytes, to.Bytes,
                    to.Column(c).OffsetBytes + to.Count * size, from.Count * size);
            }
            to.Count += from.Count;
        }
    }
}
