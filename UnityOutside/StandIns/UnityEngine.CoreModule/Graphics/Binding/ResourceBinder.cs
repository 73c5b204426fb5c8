namespace StandIns.Graphics;

/// <summary>Brings a draw or dispatch what its shader names, by name, and refuses what does not fit.</summary>
sealed unsafe class ResourceBinder(GpuDevice device)
{
    readonly GpuDevice m_device = device;
    readonly SamplerTable m_samplers = new SamplerTable(device);

    /// <summary>Makes the textures of a scope that are not there yet; within a pass that cannot be done, so it ends.</summary>
    internal static void MakeTextures(GpuRecording recording, RenderTargets targets, ShaderLayout layout, in PropertyScope scope)
    {
        foreach (ShaderResource resource in layout.Resources)
            if ((resource.Kind == DescriptorType.SampledImage || resource.Kind == DescriptorType.StorageImage)
                && scope.TryGet(resource.NameId, out PropertyValue value) && value.Reference is RenderTexture texture
                && !texture.IsCreated())
            {
                targets.Close(recording);
                texture.ImageFor(value.IsDepth);
            }
    }

    internal void Bind(GpuRecording recording, PipelineBindPoint point, string shader, ShaderLayout layout,
        in PropertyScope scope)
    {
        int count = layout.Resources.Length;
        if (count == 0)
            return;
        WriteDescriptorSet* writes = stackalloc WriteDescriptorSet[count];
        DescriptorBufferInfo* buffers = stackalloc DescriptorBufferInfo[count];
        DescriptorImageInfo* images = stackalloc DescriptorImageInfo[count];
        for (int i = 0; i < count; i++)
        {
            ShaderResource resource = layout.Resources[i];
            buffers[i] = default;
            images[i] = new DescriptorImageInfo { ImageLayout = ImageLayout.General };
            switch (resource.Kind)
            {
                case DescriptorType.UniformBuffer:
                    buffers[i] = Constants(recording, resource, scope);
                    break;
                case DescriptorType.StorageBuffer:
                    buffers[i] = Storage(recording, shader, resource, scope);
                    break;
                case DescriptorType.Sampler:
                    images[i].Sampler = m_samplers.Find(resource, scope);
                    break;
                default:
                    images[i].ImageView = Image(shader, resource, scope);
                    break;
            }
            writes[i] = new WriteDescriptorSet(dstBinding: (uint)resource.Binding, descriptorCount: 1,
                descriptorType: resource.Kind, pBufferInfo: &buffers[i], pImageInfo: &images[i]);
        }
        m_device.PushDescriptors(recording.Commands, point, layout.Pipeline, 0, (uint)count, writes);
    }

    static DescriptorBufferInfo Constants(GpuRecording recording, ShaderResource resource, in PropertyScope scope)
    {
        ulong bytes = (ulong)resource.Size;
        byte* target = recording.Uploads.Take(bytes, out GpuBuffer buffer, out ulong offset);
        UnsafeUtility.MemClear(target, (long)bytes);
        ConstantWriter.Write(resource, scope, target);
        return new DescriptorBufferInfo { Buffer = buffer.Handle, Offset = offset, Range = bytes };
    }

    static DescriptorBufferInfo Storage(GpuRecording recording, string shader, ShaderResource resource, in PropertyScope scope)
    {
        if (!scope.TryGet(resource.NameId, out PropertyValue value) || !(value.Reference is GraphicsBuffer buffer))
            throw new InvalidOperationException($"{shader}: no buffer is set as {resource.Name}");
        const GraphicsBuffer.Target storage = GraphicsBuffer.Target.Structured | GraphicsBuffer.Target.Raw
            | GraphicsBuffer.Target.Append | GraphicsBuffer.Target.Counter;
        if ((buffer.target & storage) == 0)
            throw new InvalidOperationException($"{shader}: {resource.Name} is set to {buffer.Label}, which was made neither "
                + $"as "
                + "Target.Structured nor as Target.Raw");
        if (resource.IsWritten && (buffer.usageFlags & GraphicsBuffer.UsageFlags.LockBufferForWrite) != 0)
            throw new InvalidOperationException($"{shader}: writes {resource.Name}, and {buffer.Label} is the host's to "
                + $"write: "
                + "Direct3D 11 has no buffer that both do");
        // Direct3D refuses such a buffer, and glslang puts a float3 of a structure where Unity's compilers do not.
        if ((buffer.target & GraphicsBuffer.Target.Raw) == 0 && buffer.stride != resource.Stride)
            throw new InvalidOperationException($"{shader}: elements of {resource.Name} have {resource.Stride} bytes, those "
                + $"of "
                + $"{buffer.Label} {buffer.stride}");
        GpuBuffer memory = buffer.ForDevice();
        memory.LastUse = recording.Number;
        return new DescriptorBufferInfo { Buffer = memory.Handle, Range = Vk.WholeSize };
    }

    static ImageView Image(string shader, ShaderResource resource, in PropertyScope scope)
    {
        if (!scope.TryGet(resource.NameId, out PropertyValue value) || !(value.Reference is Texture texture))
            throw new InvalidOperationException($"{shader}: no texture is set as {resource.Name}");
        if (texture == null)
            throw new InvalidOperationException($"{shader}: the texture set as {resource.Name} was destroyed");
        if (resource.Kind == DescriptorType.StorageImage && !(texture is RenderTexture { enableRandomWrite: true }))
            throw new InvalidOperationException($"{shader}: {resource.Name} is written, and {texture.name} was made without "
                + "enableRandomWrite");
        if (resource.IsArray != (texture.dimension == UnityEngine.Rendering.TextureDimension.Tex2DArray))
            throw new InvalidOperationException($"{shader}: {resource.Name} is {(resource.IsArray ? "" : "not ")}an array of "
                + "textures, "
                + $"{texture.name} is {texture.dimension}");
        GpuImage image = texture.ImageFor(value.IsDepth);
        if (resource.Format != Format.Undefined && resource.Format != image.Format)
            throw new InvalidOperationException($"{shader}: {resource.Name} is {resource.Format} in the shader, and "
                + $"{texture.name} is {image.Format}");
        return image.View;
    }
}
