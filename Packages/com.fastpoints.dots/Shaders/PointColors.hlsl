// Colours as bytes, as sRGB and as light.
#ifndef FASTPOINTS_POINT_COLORS_INCLUDED
#define FASTPOINTS_POINT_COLORS_INCLUDED

float3 FastPointsUnpackColor(uint color)
{
    return float3(color & 0xFFu, color >> 8 & 0xFFu, color >> 16 & 0xFFu) / 255.0;
}

// IEC 61966-2-1. No colour is below 0; abs tells Direct3D's compiler, which warns of pow otherwise.
float3 FastPointsLinearFromSrgb(float3 color)
{
    float3 low = color / 12.92;
    float3 high = pow(abs(color + 0.055) / 1.055, 2.4);
    return float3(color.x <= 0.04045 ? low.x : high.x, color.y <= 0.04045 ? low.y : high.y, color.z <= 0.04045 ? low.z : high.z);
}

float3 FastPointsSrgbFromLinear(float3 light)
{
    float3 low = light * 12.92;
    float3 high = 1.055 * pow(abs(light), 1.0 / 2.4) - 0.055;
    return float3(light.x <= 0.0031308 ? low.x : high.x, light.y <= 0.0031308 ? low.y : high.y,
        light.z <= 0.0031308 ? low.z : high.z);
}

#endif
