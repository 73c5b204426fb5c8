using System;
using FastPoints.Drawing;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using UnityEngine;
using UnityEngine.Rendering;

namespace FastPoints.Rendering
{
    // The lists that a camera's draws read, in one buffer: some devices give vertex shaders no more than four.
    internal sealed class ListBuffer : IDisposable
    {
        readonly GrowingBuffer m_buffer = new GrowingBuffer(GraphicsBuffer.Target.Raw, sizeof(uint));
        NativeArray<uint> m_colors = Palettes.CreateAll(Allocator.Persistent);
        int m_endByte, m_nodesAt, m_cloudsAt, m_nodeOfInstanceAt, m_sizeNodesAt, m_clipBoxesAt, m_lastOfNodeAt;

        public void Write(CommandBuffer commands, DrawList list)
        {
            m_endByte = m_colors.Length * sizeof(uint);
            m_nodesAt = Reserve(list.Nodes);
            m_cloudsAt = Reserve(list.Clouds);
            m_nodeOfInstanceAt = Reserve(list.NodeOfInstance);
            m_sizeNodesAt = Reserve(list.SizeNodes);
            m_clipBoxesAt = Reserve(list.ClipBoxes);
            m_lastOfNodeAt = Reserve(list.PreviousFirstInstanceOfNode);
            if (m_buffer.Reserve(m_endByte))
                m_buffer.Write(commands, m_colors);
            m_buffer.Write(commands, list.Nodes, m_nodesAt);
            m_buffer.Write(commands, list.Clouds, m_cloudsAt);
            m_buffer.Write(commands, list.NodeOfInstance, m_nodeOfInstanceAt);
            m_buffer.Write(commands, list.SizeNodes, m_sizeNodesAt);
            m_buffer.Write(commands, list.ClipBoxes, m_clipBoxesAt);
            m_buffer.Write(commands, list.PreviousFirstInstanceOfNode, m_lastOfNodeAt);
        }

        public void Set(MaterialPropertyBlock properties)
        {
            properties.SetBuffer(ShaderNames.Lists, m_buffer.Buffer);
            properties.SetInteger(ShaderNames.NodesAt, m_nodesAt);
            properties.SetInteger(ShaderNames.CloudsAt, m_cloudsAt);
            properties.SetInteger(ShaderNames.NodeOfInstanceAt, m_nodeOfInstanceAt);
            properties.SetInteger(ShaderNames.SizeNodesAt, m_sizeNodesAt);
            properties.SetInteger(ShaderNames.ClipBoxesAt, m_clipBoxesAt);
        }

        public void Set(CommandBuffer commands, ComputeShader shader, int kernel)
        {
            commands.SetComputeBufferParam(shader, kernel, ShaderNames.Lists, m_buffer.Buffer);
            commands.SetComputeIntParam(shader, ShaderNames.NodesAt, m_nodesAt);
            commands.SetComputeIntParam(shader, ShaderNames.CloudsAt, m_cloudsAt);
            commands.SetComputeIntParam(shader, ShaderNames.NodeOfInstanceAt, m_nodeOfInstanceAt);
            commands.SetComputeIntParam(shader, ShaderNames.ClipBoxesAt, m_clipBoxesAt);
            commands.SetComputeIntParam(shader, ShaderNames.LastOfNodeAt, m_lastOfNodeAt);
        }

        public void Dispose()
        {
            m_buffer.Dispose();
            if (m_colors.IsCreated)
                m_colors.Dispose();
        }

        // Buffers are written in whole values: a list begins at a multiple of its values' size.
        int Reserve<T>(NativeArray<T> values) where T : unmanaged
        {
            int size = UnsafeUtility.SizeOf<T>();
            int at = (m_endByte + size - 1) / size * size;
            m_endByte = checked(at + values.Length * size);
            return at;
        }
    }
}
