using System;
using StandIns.Graphics;
using UnityEngine.Rendering;

namespace UnityEngine
{
    public class Graphics
    {
        static CommandReplay s_replay;

        /// <summary>Sends the commands to the device, and does not wait for them.</summary>
        /// <exception cref="InvalidOperationException">A command names what is not there: the message says which.</exception>
        public static void ExecuteCommandBuffer(CommandBuffer buffer)
        {
            if (buffer == null)
                throw new ArgumentNullException(nameof(buffer));
            buffer.CheckReleased();
            s_replay ??= new CommandReplay(GpuDevice.Current);
            s_replay.Run(buffer);
        }

        /// <summary>All of one buffer into another of the same size.</summary>
        public static void CopyBuffer(GraphicsBuffer source, GraphicsBuffer dest)
        {
            using var commands = new CommandBuffer();
            commands.CopyBuffer(source, dest);
            ExecuteCommandBuffer(commands);
        }
    }
}
